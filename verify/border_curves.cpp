#include <foldless/verify/border_curves.h>

#include <foldless/io/union_find.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace foldless::verification {
namespace {

/// Arcs of a chain that are tried for its witness: one suffices unless other sheets are near.
constexpr std::size_t most_witnesses = 256;

} // namespace

BorderCurves::BorderCurves(const Correspondents& all, const Meshes& meshes) : all_(all), meshes_(meshes) {
    for (std::size_t f = 0; f < meshes.scan.faces.size(); ++f) {
        const auto face = static_cast<std::int32_t>(f);
        if (all.base.scan_face_is_frozen(face) || !all.has_places(face)) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const std::int32_t across = meshes.scan_adjacency.neighbour(face, (k + 2) % 3);
            if (across < 0 || all.base.scan_face_is_frozen(across)) {
                add_side(face, k);
            }
        }
    }
    sort_by_triangle(arcs_);
    for (const BorderArc& arc : arcs_) {
        if (faces_.empty() || faces_.back() != arc.triangle) {
            faces_.push_back(arc.triangle);
        }
    }
}

void BorderCurves::add_side(std::int32_t scan_face, int k) {
    const Triangle& corners = meshes_.scan.faces[scan_face];
    const BorderEdge edge{scan_face, {corners[k], corners[(k + 1) % 3]}};
    if (!all_.association.is_base_edge(edge.ends[0], edge.ends[1])) {
        sides_.push_back({edge, false});
        add_traced(edge);
        return;
    }
    const std::vector<std::int32_t>& base_of = meshes_.kept.base_of;
    const std::int32_t other = meshes_.base_adjacency.face_with(base_of[edge.ends[1]], base_of[edge.ends[0]]);
    sides_.push_back({edge, other < 0 || !all_.base.is_moving(other)});
    add_base_edge(edge);
}

/// The edge on the moving faces on both of its sides.
void BorderCurves::add_base_edge(const BorderEdge& edge) {
    const ScanLine line{&meshes_.scan.positions[edge.ends[0]], &meshes_.scan.positions[edge.ends[1]]};
    const std::int32_t a = meshes_.kept.base_of[edge.ends[0]];
    const std::int32_t b = meshes_.kept.base_of[edge.ends[1]];
    for (const std::int32_t face : {meshes_.base_adjacency.face_with(a, b), meshes_.base_adjacency.face_with(b, a)}) {
        if (face >= 0 && all_.base.is_moving(face)) {
            add(edge, line,
                {face,
                 {on_pillar(all_.base, face, a, Displacement()), true},
                 {on_pillar(all_.base, face, b, Displacement()), true}});
        }
    }
}

void BorderCurves::add_traced(const BorderEdge& edge) {
    const auto [a, b] = edge.ends;
    const std::optional<std::vector<WallCrossing>> crossings = all_.association.follow(a, b);
    if (!crossings) {
        return; // `trace` says so
    }
    const FacePosition start = all_.association.start(a, b);
    LinePieces pieces(start.face, start.at);
    for (const WallCrossing& crossing : *crossings) {
        pieces.cross(crossing.wall, crossing.t, crossing.next_face,
                     wall_across(all_.base, crossing.face, crossing.wall));
    }
    const ScanLine line{&meshes_.scan.positions[a], &meshes_.scan.positions[b]};
    for (const LinePiece& piece : pieces.end(all_.association.start(b, a).at)) {
        add(edge, line, piece);
    }
}

void BorderCurves::add(const BorderEdge& edge, const ScanLine& line, const LinePiece& piece) {
    arcs_.push_back(border_arc(all_.base.face(piece.triangle).triangle, edge, line, piece));
}

void BorderCurves::settle(Degree& degree) const {
    for (const std::int32_t face : faces_) {
        degree.settle(face);
    }
}

void BorderCurves::check(const Meetings& meetings, Stages& stages, double share, Findings& findings) const {
    stages.for_each(faces_.size(), share, [&](std::size_t n) { check_face(faces_[n], findings); });
    check_pillars(findings);
    check_chains(meetings, findings);
}

void BorderCurves::check_face(std::int32_t base_face, Findings& findings) const {
    const std::span<const BorderArc> here = arcs_on(arcs_, base_face);
    report(first_meeting(here), findings);
    for (int k = 0; k < 3; ++k) {
        const std::int32_t across = all_.base.face(base_face).across[k];
        if (across > base_face) { // each wall once
            const CommonWall wall{k, wall_across(all_.base, base_face, k)};
            report(first_meeting_on_wall(here, arcs_on(arcs_, across), wall), findings);
        }
    }
}

/// Two border vertices on one pillar lie over each other.
void BorderCurves::check_pillars(Findings& findings) const {
    std::map<std::int32_t, std::int32_t> on_pillar;
    for (const Side& side : sides_) {
        for (const std::int32_t vertex : side.edge.ends) {
            const std::int32_t pillar = all_.association.place(vertex).pillar;
            if (pillar >= 0 && on_pillar.emplace(pillar, vertex).first->second != vertex) {
                findings.add({.violation = Violation::overlap,
                              .scan_vertex = vertex,
                              .scan_face = side.edge.scan_face,
                              .position = meshes_.scan.positions[vertex]});
            }
        }
    }
}

/// The chain of each side: loops, cut where more than two sides meet, as there the parts on their left could lie over
/// each other though their borders do not meet.
std::vector<std::uint32_t> BorderCurves::chain_of_sides() const {
    std::map<std::int32_t, std::vector<std::uint32_t>> at_vertex;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        for (const std::int32_t vertex : sides_[i].edge.ends) {
            at_vertex[vertex].push_back(static_cast<std::uint32_t>(i));
        }
    }
    UnionFind chains(sides_.size());
    for (const auto& [vertex, sides] : at_vertex) {
        if (sides.size() == 2) {
            chains.join(sides[0], sides[1]);
        }
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        result.push_back(chains.find(static_cast<std::uint32_t>(i)));
    }
    return result;
}

void BorderCurves::check_chains(const Meetings& meetings, Findings& findings) const {
    struct Chain {
        bool is_outermost = false; ///< somewhere
        std::vector<const BorderArc*> arcs;
    };
    std::map<std::uint32_t, Chain> chains;
    std::map<std::array<std::int32_t, 2>, std::uint32_t> chain_of_edge;
    const std::vector<std::uint32_t> chain_of = chain_of_sides();
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        Chain& chain = chains[chain_of[i]];
        chain.is_outermost = chain.is_outermost || sides_[i].is_outermost;
        chain_of_edge[sides_[i].edge.ends] = chain_of[i];
    }
    for (const BorderArc& arc : arcs_) {
        Chain& chain = chains[chain_of_edge.at(arc.edge.ends)];
        if (chain.arcs.size() < most_witnesses) {
            chain.arcs.push_back(&arc);
        }
    }
    for (const auto& [number, chain] : chains) {
        // A chain without arcs has edges that could not be followed: `trace` says so.
        if (!chain.is_outermost && !chain.arcs.empty() && !has_witness(chain.arcs, meetings)) {
            report(chain.arcs.front(), findings);
        }
    }
}

bool BorderCurves::has_witness(const std::vector<const BorderArc*>& arcs, const Meetings& meetings) const {
    return std::any_of(arcs.begin(), arcs.end(), [&](const BorderArc* arc) {
        const Range part = arc->image.parameters();
        const double s = part.lo + 0.5 * (part.hi - part.lo);
        return part.lo < s && s < part.hi && is_covered_once(*arc, s, meetings);
    });
}

bool BorderCurves::is_covered_once(const BorderArc& arc, double s, const Meetings& meetings) const {
    const Range range = all_.base.face(arc.triangle).range;
    auto met = std::lower_bound(meetings.begin(), meetings.end(), std::pair(arc.triangle, std::int32_t(-1)));
    for (; met != meetings.end() && met->first == arc.triangle; ++met) {
        if (met->second != arc.edge.scan_face && !certainly_misses(arc.image, s, all_.triangle(met->second), range)) {
            return false;
        }
    }
    return true;
}

/// Null is no finding.
void BorderCurves::report(const BorderArc* arc, Findings& findings) const {
    if (arc == nullptr) {
        return;
    }
    const auto& [a, b] = arc->edge.ends;
    findings.add({.violation = Violation::overlap,
                  .scan_face = arc->edge.scan_face,
                  .base_face = arc->triangle,
                  .position = 0.5 * (meshes_.scan.positions[a] + meshes_.scan.positions[b])});
}

} // namespace foldless::verification
