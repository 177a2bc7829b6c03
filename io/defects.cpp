#include <foldless/io/defects.h>

#include <foldless/io/corner.h>
#include <foldless/io/edge_table.h>
#include <foldless/io/printable.h>
#include <foldless/io/union_find.h>
#include <foldless/io/zero_area.h>

#include <algorithm>
#include <array>

namespace foldless {

namespace {

struct DefectName {
    std::size_t Defects::*count;
    const char* one;
    const char* many;
};

constexpr std::array<DefectName, 8> defect_names{{
    {&Defects::not_finite, "vertex that is not finite", "vertices that are not finite"},
    {&Defects::index_out_of_range, "face with an index out of range", "faces with an index out of range"},
    {&Defects::repeated_index, "face with a repeated index", "faces with a repeated index"},
    {&Defects::zero_area, "zero-area face", "zero-area faces"},
    {&Defects::non_manifold_edges, "non-manifold edge", "non-manifold edges"},
    {&Defects::inconsistent_edges, "inconsistently oriented edge", "inconsistently oriented edges"},
    {&Defects::non_manifold_vertices, "non-manifold vertex", "non-manifold vertices"},
    {&Defects::non_orientable_components, "non-orientable component", "non-orientable components"},
}};

/// Gathers an inspection in one pass over the vertices, one over the faces and one over the edges.
class Inspector {
public:
    explicit Inspector(const Scan& scan)
        : scan_(scan), used_(scan.positions.size(), 0), bordering_(scan.positions.size(), 0),
          parts_(scan.positions.size()), loops_(scan.positions.size()), corners_(3 * scan.faces.size()),
          sides_(scan.faces.size()) {}

    Inspection inspect() {
        defects_.no_faces = scan_.faces.empty() ? 1 : 0;
        inspect_vertices();
        inspect_faces();
        const EdgeTable edges(scan_.faces, scan_.positions.size());
        edges.for_each_edge([this](std::int32_t a, std::int32_t b, std::span<const EdgeTable::Entry> entries) {
            inspect_edge(a, b, entries);
        });
        count_fans();
        defects_.non_orientable_components = sides_.contradictions();
        finish_topology();
        return {defects_, topology_};
    }

private:
    void inspect_vertices() {
        defects_.not_finite = static_cast<std::size_t>(
            std::ranges::count_if(scan_.positions, [](const Vec3& position) { return !position.allFinite(); }));
    }

    void inspect_faces() {
        for (const Triangle& face : scan_.faces) {
            inspect_face(face);
        }
    }

    void inspect_face(const Triangle& face) {
        if (!std::ranges::all_of(face, [this](std::int32_t index) { return is_vertex(index); })) {
            ++defects_.index_out_of_range;
            return;
        }
        for (const std::int32_t vertex : face) {
            used_[static_cast<std::size_t>(vertex)] = 1;
        }
        if (!has_three_vertices(face, scan_.positions.size())) {
            ++defects_.repeated_index;
            return;
        }
        ++whole_faces_;
        const ScanTriangle triangle{position(face[0]), position(face[1]), position(face[2])};
        const bool finite = std::ranges::all_of(triangle, [](const Vec3& corner) { return corner.allFinite(); });
        defects_.zero_area += finite && has_zero_area(triangle) ? 1 : 0;
    }

    void inspect_edge(std::int32_t a, std::int32_t b, std::span<const EdgeTable::Entry> entries) {
        ++edges_;
        part_joins_ += parts_.join(number(a), number(b)) ? 1 : 0;
        if (entries.size() == 1) {
            inspect_border_edge(a, b);
        } else if (entries.size() == 2) {
            inspect_inner_edge(a, b, entries[0].face, entries[1].face);
        } else {
            ++defects_.non_manifold_edges;
        }
    }

    void inspect_border_edge(std::int32_t a, std::int32_t b) {
        ++topology_.boundary_edges;
        bordering_[number(a)] = 1;
        bordering_[number(b)] = 1;
        loop_joins_ += loops_.join(number(a), number(b)) ? 1 : 0;
    }

    void inspect_inner_edge(std::int32_t a, std::int32_t b, std::int32_t first, std::int32_t second) {
        const bool same_direction = ascends(first, a, b) == ascends(second, a, b);
        defects_.inconsistent_edges += same_direction ? 1 : 0;
        sides_.join(number(first), number(second), same_direction);
        corners_.join(corner(first, a), corner(second, a));
        corners_.join(corner(first, b), corner(second, b));
    }

    /// The corners at a vertex that are joined over inner edges form one fan; each set of corners is counted once, at
    /// the corner that names it.
    void count_fans() {
        std::vector<std::uint32_t> fans(scan_.positions.size(), 0);
        for (std::size_t face = 0; face < scan_.faces.size(); ++face) {
            if (!has_three_vertices(scan_.faces[face], scan_.positions.size())) {
                continue;
            }
            for (std::size_t i = 0; i < 3; ++i) {
                const auto id = static_cast<std::uint32_t>(3 * face + i);
                fans[number(scan_.faces[face][i])] += corners_.find(id) == id ? 1 : 0;
            }
        }
        defects_.non_manifold_vertices =
            static_cast<std::size_t>(std::ranges::count_if(fans, [](std::uint32_t count) { return count > 1; }));
    }

    /// Sets of vertices are counted as vertices less the joins that made fewer of them.
    void finish_topology() {
        const auto used = static_cast<std::size_t>(std::ranges::count(used_, 1));
        topology_.unused_vertices = scan_.positions.size() - used;
        topology_.components = used - part_joins_;
        topology_.boundary_loops = static_cast<std::size_t>(std::ranges::count(bordering_, 1)) - loop_joins_;
        topology_.euler_characteristic =
            static_cast<long long>(used) - static_cast<long long>(edges_) + static_cast<long long>(whole_faces_);
    }

    [[nodiscard]] bool is_vertex(std::int32_t index) const {
        return index >= 0 && static_cast<std::size_t>(index) < scan_.positions.size();
    }

    static std::uint32_t number(std::int32_t index) { return static_cast<std::uint32_t>(index); }

    [[nodiscard]] const Vec3& position(std::int32_t vertex) const { return scan_.positions[number(vertex)]; }

    [[nodiscard]] std::uint32_t corner(std::int32_t face, std::int32_t vertex) const {
        return corner_of(scan_.faces[number(face)], face, vertex);
    }

    /// Whether the face runs from a to b.
    [[nodiscard]] bool ascends(std::int32_t face, std::int32_t a, std::int32_t b) const {
        return runs_along(scan_.faces[number(face)], a, b);
    }

    const Scan& scan_;
    Defects defects_;
    Topology topology_;
    std::vector<std::uint8_t> used_;      ///< vertices that a face names
    std::vector<std::uint8_t> bordering_; ///< vertices of border edges
    UnionFind parts_;                     ///< vertices, joined by edges
    UnionFind loops_;                     ///< vertices, joined by border edges
    UnionFind corners_;                   ///< corners 3 face + i, joined around their vertex
    SidedUnionFind sides_;                ///< faces; those on one side must be turned over
    std::size_t part_joins_ = 0;
    std::size_t loop_joins_ = 0;
    std::size_t edges_ = 0;
    std::size_t whole_faces_ = 0;
};

} // namespace

bool Defects::any() const {
    return no_faces > 0 ||
           std::ranges::any_of(defect_names, [this](const DefectName& name) { return this->*name.count > 0; });
}

std::string Defects::text() const {
    std::string text = no_faces > 0 ? "no faces" : "";
    for (const auto& [count, one, many] : defect_names) {
        if (this->*count > 0) {
            text += (text.empty() ? "" : ", ") + counted(this->*count, one, many);
        }
    }
    return text;
}

Inspection inspect(const Scan& scan) {
    return Inspector(scan).inspect();
}

void require_no_defects(const Scan& scan) {
    if (const Defects defects = inspect(scan).defects; defects.any()) {
        throw RefusedMesh(defects.text());
    }
}

} // namespace foldless
