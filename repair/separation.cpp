#include <foldless/repair/separation.h>

#include <foldless/io/corner.h>
#include <foldless/io/edge_table.h>
#include <foldless/io/union_find.h>
#include <foldless/repair/continuations.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace foldless {

namespace {

/// An edge of three or more faces.
struct CrowdedEdge {
    std::int32_t a;
    std::int32_t b;
    std::vector<std::int32_t> faces;
    std::vector<std::pair<std::int32_t, std::int32_t>> continued; ///< pairs of faces that stay together
};

/// How often pairs that do not fit are found out one by one, before all that are left are given up. Pairs that do not
/// fit are rare, and most show at once.
constexpr int most_rounds = 4;

// Why the result is a manifold. A fan is a chain of corners around a vertex, neighbours across an edge that both faces
// run along in opposite directions. Each side of a face is across one other face at most, so that a fan is a ring, or a
// path whose two ends are sides without a neighbour, one of which leads to the vertex and one away from it.
//
// Two faces at an edge that get the same vertices at both of its ends lie in the same fan at both. Say that no face has
// a neighbour across the edge: then both faces are ends of that path, so that there are two of them at most, and they
// run along the edge in opposite directions; the path becomes a ring. So an edge whose two faces disagree is cut open,
// and if the pairs at all edges of three or more faces are given up, none is left. As long as there are pairs, these
// edges are asked whether three of their faces have the same vertices; all other edges have two faces at most.
class Separation {
public:
    explicit Separation(Scan& scan)
        : scan_(scan), edges_(scan.faces, scan.positions.size()), inner_(3 * scan.faces.size()) {
        edges_.for_each_edge([this](std::int32_t a, std::int32_t b, std::span<const EdgeTable::Entry> entries) {
            add_edge(a, b, entries);
        });
    }

    void separate(RepairCounts& counts) {
        UnionFind fans = fans_of_manifold();
        counts.unorientable_edges += unorientable_;
        counts.non_manifold_edges += crowded_.size();
        split_vertices(fans, counts);
    }

private:
    void add_edge(std::int32_t a, std::int32_t b, std::span<const EdgeTable::Entry> entries) {
        if (entries.size() == 2) {
            const std::pair faces{entries[0].face, entries[1].face};
            const bool agree =
                runs_along(scan_.faces[faces.first], a, b) != runs_along(scan_.faces[faces.second], a, b);
            if (agree) {
                join(inner_, faces, a, b);
            }
            unorientable_ += agree ? 0 : 1;
        } else if (entries.size() > 2) {
            CrowdedEdge edge{a, b, {}, {}};
            std::ranges::transform(entries, std::back_inserter(edge.faces), &EdgeTable::Entry::face);
            edge.continued = continuations(scan_, edge.faces, a, b);
            crowded_.push_back(std::move(edge));
        }
    }

    [[nodiscard]] std::uint32_t corner(std::int32_t face, std::int32_t vertex) const {
        return corner_of(scan_.faces[face], face, vertex);
    }

    void join(UnionFind& fans, std::pair<std::int32_t, std::int32_t> faces, std::int32_t a, std::int32_t b) const {
        fans.join(corner(faces.first, a), corner(faces.second, a));
        fans.join(corner(faces.first, b), corner(faces.second, b));
    }

    /// Joins corners into fans, giving pairs up until no edge has three faces.
    UnionFind fans_of_manifold() {
        for (int round = 0;; ++round) {
            UnionFind fans = inner_;
            for (const CrowdedEdge& edge : crowded_) {
                for (const auto& pair : edge.continued) {
                    join(fans, pair, edge.a, edge.b);
                }
            }
            if (!give_up_misfits(fans, round >= most_rounds)) {
                return fans;
            }
        }
    }

    /// Whether there was a misfit; then its pairs are given up, or all pairs.
    bool give_up_misfits(UnionFind& fans, bool all) {
        bool found = false;
        for (CrowdedEdge& edge : crowded_) {
            if (!edge.continued.empty() && is_misfit(fans, edge)) {
                edge.continued.clear();
                found = true;
            }
        }
        if (found && all) {
            std::ranges::for_each(crowded_, [](CrowdedEdge& edge) { edge.continued.clear(); });
        }
        return found;
    }

    /// Whether three faces at the edge would have the same two vertices.
    [[nodiscard]] bool is_misfit(UnionFind& fans, const CrowdedEdge& edge) const {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        for (const std::int32_t face : edge.faces) {
            ends.emplace_back(fans.find(corner(face, edge.a)), fans.find(corner(face, edge.b)));
        }
        std::ranges::sort(ends);
        for (std::size_t i = 2; i < ends.size(); ++i) {
            if (ends[i] == ends[i - 2]) {
                return true;
            }
        }
        return false;
    }

    /// The number of a fan is its smallest corner, which comes before its others here.
    void split_vertices(UnionFind& fans, RepairCounts& counts) {
        enum : std::uint8_t { free, taken, split };
        std::vector<std::uint8_t> state(scan_.positions.size(), free);
        std::vector<std::int32_t> vertex_of(3 * scan_.faces.size());
        for (std::uint32_t id = 0; id < vertex_of.size(); ++id) {
            std::int32_t& vertex = scan_.faces[id / 3][id % 3];
            const std::uint32_t fan = fans.find(id);
            if (fan != id) {
                vertex_of[id] = vertex_of[fan];
            } else if (state[vertex] == free) {
                vertex_of[id] = vertex;
                state[vertex] = taken;
            } else {
                vertex_of[id] = static_cast<std::int32_t>(scan_.positions.size());
                scan_.positions.push_back(Vec3(scan_.positions[vertex]));
                counts.split_vertices += state[vertex] == taken ? 1 : 0;
                state[vertex] = split;
                ++counts.added_vertices;
            }
            vertex = vertex_of[id];
        }
    }

    Scan& scan_;
    EdgeTable edges_;
    UnionFind inner_; ///< corners, joined over edges of two faces
    std::vector<CrowdedEdge> crowded_;
    std::size_t unorientable_ = 0;
};

} // namespace

void separate_fans(Scan& scan, RepairCounts& counts) {
    Separation(scan).separate(counts);
}

} // namespace foldless
