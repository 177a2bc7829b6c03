#include <foldless/predicates/border_arcs.h>

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

bool may_meet(const BorderArc& a, const BorderArc& b) {
    return a.edge.scan_face != b.edge.scan_face;
}

} // namespace

BorderArc border_arc(const BaseTriangle& triangle, const BorderEdge& edge, const ScanLine& line,
                     const LinePiece& piece) {
    return {piece.triangle,
            edge,
            {piece.from.is_of_line ? edge.ends[0] : -1, piece.to.is_of_line ? edge.ends[1] : -1},
            ImageArc(triangle, line, piece.from, piece.to)};
}

void sort_by_triangle(std::vector<BorderArc>& arcs) {
    std::stable_sort(arcs.begin(), arcs.end(), [](const BorderArc& a, const BorderArc& b) {
        return std::pair(a.triangle, a.image.bounds(0).lo) < std::pair(b.triangle, b.image.bounds(0).lo);
    });
}

std::span<const BorderArc> arcs_on(const std::vector<BorderArc>& arcs, std::int32_t triangle) {
    const auto below = [](const BorderArc& arc, std::int32_t t) { return arc.triangle < t; };
    const auto first = std::lower_bound(arcs.begin(), arcs.end(), triangle, below);
    return {first, std::lower_bound(first, arcs.end(), triangle + 1, below)};
}

const BorderArc* first_meeting(std::span<const BorderArc> arcs) {
    for (auto a = arcs.begin(); a != arcs.end(); ++a) {
        for (auto b = a + 1; b != arcs.end() && b->image.bounds(0).lo <= a->image.bounds(0).hi; ++b) {
            if (may_meet(*a, *b) && !are_apart(a->image, b->image, shared_point(a->vertices, b->vertices))) {
                return &*a;
            }
        }
    }
    return nullptr;
}

const BorderArc* first_meeting_on_wall(std::span<const BorderArc> a, std::span<const BorderArc> b,
                                       const CommonWall& wall) {
    for (const BorderArc& x : a) {
        if (x.image.bounds(wall.a).lo > 0) {
            continue;
        }
        for (const BorderArc& y : b) {
            if (may_meet(x, y) && !are_apart_on_wall(x.image, y.image, wall, shared_point(x.vertices, y.vertices))) {
                return &x;
            }
        }
    }
    return nullptr;
}

} // namespace foldless
