#include <foldless/verify/border_curves.h>

#include <foldless/io/union_find.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace foldless::verification {
namespace {

/// Arcs of a loop that are tried for its witness: one suffices unless other sheets are near.
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
                add_edge(face, k);
            }
        }
    }
    sort();
}

void BorderCurves::add_edge(std::int32_t scan_face, int k) {
    const Triangle& corners = meshes_.scan.faces[scan_face];
    BorderEdge edge{{corners[k], corners[(k + 1) % 3]}, scan_face, false};
    if (all_.association.is_base_edge(edge.ends[0], edge.ends[1])) {
        const std::vector<std::int32_t>& base_of = meshes_.kept.base_of;
        const std::int32_t other = meshes_.base_adjacency.face_with(base_of[edge.ends[1]], base_of[edge.ends[0]]);
        edge.is_outermost = other < 0 || !all_.base.is_moving(other);
        edges_.push_back(edge);
        add_along_base_edge(edge);
    } else {
        edges_.push_back(edge);
        add_traced(edge);
    }
}

/// The edge on the moving faces on both of its sides.
void BorderCurves::add_along_base_edge(const BorderEdge& edge) {
    const ScanLine line{&meshes_.scan.positions[edge.ends[0]], &meshes_.scan.positions[edge.ends[1]]};
    const std::int32_t a = meshes_.kept.base_of[edge.ends[0]];
    const std::int32_t b = meshes_.kept.base_of[edge.ends[1]];
    for (const std::int32_t face : {meshes_.base_adjacency.face_with(a, b), meshes_.base_adjacency.face_with(b, a)}) {
        if (face >= 0 && all_.base.is_moving(face)) {
            add(line, {face,
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
        add(line, piece);
    }
}

void BorderCurves::add(const ScanLine& line, const LinePiece& piece) {
    const auto edge = static_cast<std::int32_t>(edges_.size()) - 1;
    const std::array<std::int32_t, 2>& ends = edges_.back().ends;
    arcs_.push_back({piece.triangle,
                     edge,
                     {piece.from.is_of_line ? ends[0] : -1, piece.to.is_of_line ? ends[1] : -1},
                     ImageArc(all_.base.face(piece.triangle).triangle, line, piece.from, piece.to)});
}

void BorderCurves::sort() {
    std::stable_sort(arcs_.begin(), arcs_.end(), [](const Arc& a, const Arc& b) {
        return std::tuple(a.base_face, a.image.bounds(0).lo) < std::tuple(b.base_face, b.image.bounds(0).lo);
    });
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
        if (faces_.empty() || faces_.back() != arcs_[i].base_face) {
            faces_.push_back(arcs_[i].base_face);
            first_arc_.push_back(i);
        }
    }
    first_arc_.push_back(arcs_.size());
}

void BorderCurves::settle(Degree& degree) const {
    for (const std::int32_t face : faces_) {
        degree.settle(face);
    }
}

void BorderCurves::check(const Meetings& meetings, Stages& stages, double share, Findings& findings) const {
    stages.for_each(faces_.size(), share, [&](std::size_t n) {
        check_face(faces_[n], findings);
        for (int k = 0; k < 3; ++k) {
            check_wall(faces_[n], k, findings);
        }
    });
    check_pillars(findings);
    check_loops(meetings, findings);
}

std::span<const BorderCurves::Arc> BorderCurves::arcs_on(std::int32_t base_face) const {
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), base_face);
    if (found == faces_.end() || *found != base_face) {
        return {};
    }
    const std::size_t n = static_cast<std::size_t>(found - faces_.begin());
    return {arcs_.data() + first_arc_[n], arcs_.data() + first_arc_[n + 1]};
}

/// Edges of one scan face do not meet: its border is a simple curve (theorem B).
bool BorderCurves::may_meet(const Arc& a, const Arc& b) const {
    return edges_[a.edge].scan_face != edges_[b.edge].scan_face;
}

void BorderCurves::check_face(std::int32_t base_face, Findings& findings) const {
    const std::span<const Arc> arcs = arcs_on(base_face);
    for (auto a = arcs.begin(); a != arcs.end(); ++a) {
        for (auto b = a + 1; b != arcs.end() && b->image.bounds(0).lo <= a->image.bounds(0).hi; ++b) {
            if (may_meet(*a, *b) && !are_apart(a->image, b->image, shared_point(a->vertices, b->vertices))) {
                report(*a, findings);
            }
        }
    }
}

/// Arcs in two faces can meet on the wall between them, where neither crosses it.
void BorderCurves::check_wall(std::int32_t base_face, int k, Findings& findings) const {
    const std::int32_t across = all_.base.face(base_face).across[k];
    if (across < base_face) {
        return; // each pair once
    }
    const CommonWall wall{k, wall_across(all_.base, base_face, k)};
    const auto near_wall = [&](std::int32_t face, int corner) {
        std::vector<const Arc*> result;
        for (const Arc& arc : arcs_on(face)) {
            if (arc.image.bounds(corner).lo <= 0) {
                result.push_back(&arc);
            }
        }
        return result;
    };
    const std::vector<const Arc*> there = near_wall(across, wall.b);
    for (const Arc* const a : there.empty() ? std::vector<const Arc*>() : near_wall(base_face, wall.a)) {
        for (const Arc* const b : there) {
            if (may_meet(*a, *b) &&
                !are_apart_on_wall(a->image, b->image, wall, shared_point(a->vertices, b->vertices))) {
                report(*a, findings);
            }
        }
    }
}

/// Two border vertices on one pillar lie over each other.
void BorderCurves::check_pillars(Findings& findings) const {
    std::map<std::int32_t, std::int32_t> on_pillar;
    for (const BorderEdge& edge : edges_) {
        for (const std::int32_t vertex : edge.ends) {
            const std::int32_t pillar = all_.association.place(vertex).pillar;
            if (pillar >= 0 && on_pillar.emplace(pillar, vertex).first->second != vertex) {
                findings.add({.violation = Violation::overlap,
                              .scan_vertex = vertex,
                              .scan_face = edge.scan_face,
                              .position = meshes_.scan.positions[vertex]});
            }
        }
    }
}

void BorderCurves::check_loops(const Meetings& meetings, Findings& findings) const {
    UnionFind loops(meshes_.scan.positions.size());
    const auto loop_of = [&](const BorderEdge& edge) { return loops.find(static_cast<std::uint32_t>(edge.ends[0])); };
    for (const BorderEdge& edge : edges_) {
        loops.join(static_cast<std::uint32_t>(edge.ends[0]), static_cast<std::uint32_t>(edge.ends[1]));
    }
    std::map<std::uint32_t, bool> is_outermost;
    for (const BorderEdge& edge : edges_) {
        bool& outermost = is_outermost[loop_of(edge)];
        outermost = outermost || edge.is_outermost;
    }
    std::map<std::uint32_t, std::vector<std::size_t>> arcs;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
        const std::uint32_t loop = loop_of(edges_[arcs_[i].edge]);
        if (!is_outermost[loop] && arcs[loop].size() < most_witnesses) {
            arcs[loop].push_back(i);
        }
    }
    for (const auto& [loop, some] : arcs) {
        if (!has_witness(some, meetings)) {
            report(arcs_[some.front()], findings);
        }
    }
}

bool BorderCurves::has_witness(const std::vector<std::size_t>& arcs, const Meetings& meetings) const {
    return std::any_of(arcs.begin(), arcs.end(), [&](std::size_t i) {
        const Range part = arcs_[i].image.parameters();
        const double s = part.lo + 0.5 * (part.hi - part.lo);
        return part.lo < s && s < part.hi && is_covered_once(arcs_[i], s, meetings);
    });
}

bool BorderCurves::is_covered_once(const Arc& arc, double s, const Meetings& meetings) const {
    const Range range = all_.base.face(arc.base_face).range;
    auto met = std::lower_bound(meetings.begin(), meetings.end(), std::pair(arc.base_face, std::int32_t(-1)));
    for (; met != meetings.end() && met->first == arc.base_face; ++met) {
        if (met->second != edges_[arc.edge].scan_face &&
            !certainly_misses(arc.image, s, all_.triangle(met->second), range)) {
            return false;
        }
    }
    return true;
}

void BorderCurves::report(const Arc& arc, Findings& findings) const {
    const BorderEdge& edge = edges_[arc.edge];
    findings.add({.violation = Violation::overlap,
                  .scan_face = edge.scan_face,
                  .base_face = arc.base_face,
                  .position = 0.5 * (meshes_.scan.positions[edge.ends[0]] + meshes_.scan.positions[edge.ends[1]])});
}

} // namespace foldless::verification
