#include <foldless/decimate/border_arcs.h>

#include <algorithm>
#include <utility>

namespace foldless {

void BorderArcs::add(const PatchedSurface& surface, const BorderEdge& edge, const LinePiece& piece,
                     const ScanLine& line) {
    arcs_.push_back({piece.triangle,
                     edge.scan_face,
                     {piece.from.is_of_line ? edge.ends[0] : -1, piece.to.is_of_line ? edge.ends[1] : -1},
                     ImageArc(surface.cell(piece.triangle).triangle, line, piece.from, piece.to)});
}

void BorderArcs::add(const PatchedSurface& surface, const BorderEdge& edge, const TracedEdge& traced) {
    const ScanLine line{traced.from.point, traced.to.point};
    LinePieces pieces(traced.from.cell, traced.from.at);
    for (const TraceCrossing& crossing : traced.crossings) {
        const int wall_of_next = (surface.corner_of(crossing.to, crossing.edge[0]) + 1) % 3;
        pieces.cross(crossing.wall, crossing.t, crossing.to, wall_of_next);
    }
    for (const LinePiece& piece : pieces.end(traced.to.at)) {
        add(surface, edge, piece, line);
    }
}

std::span<const BorderArcs::Arc> BorderArcs::on(int cell) const {
    const auto below = [](const Arc& arc, int c) { return arc.cell < c; };
    const auto first = std::lower_bound(arcs_.begin(), arcs_.end(), cell, below);
    return {first, std::lower_bound(first, arcs_.end(), cell + 1, below)};
}

/// Edges of one scan face do not meet: its border is a simple curve (theorem B).
bool BorderArcs::are_apart_in_cell(std::span<const Arc> arcs) {
    for (auto a = arcs.begin(); a != arcs.end(); ++a) {
        for (auto b = a + 1; b != arcs.end() && b->image.bounds(0).lo <= a->image.bounds(0).hi; ++b) {
            if (a->scan_face != b->scan_face &&
                !are_apart(a->image, b->image, shared_point(a->vertices, b->vertices))) {
                return false;
            }
        }
    }
    return true;
}

bool BorderArcs::are_apart_at_wall(std::span<const Arc> here, std::span<const Arc> there, const CommonWall& wall) {
    for (const Arc& a : here) {
        if (a.image.bounds(wall.a).lo > 0) {
            continue;
        }
        for (const Arc& b : there) {
            if (a.scan_face != b.scan_face &&
                !are_apart_on_wall(a.image, b.image, wall, shared_point(a.vertices, b.vertices))) {
                return false;
            }
        }
    }
    return true;
}

Verdict BorderArcs::test(PatchedSurface& surface) {
    std::stable_sort(arcs_.begin(), arcs_.end(), [](const Arc& a, const Arc& b) {
        return std::pair(a.cell, a.image.bounds(0).lo) < std::pair(b.cell, b.image.bounds(0).lo);
    });
    for (int c = 0; c < surface.new_cells(); ++c) {
        const std::span<const Arc> here = on(c);
        if (!are_apart_in_cell(here)) {
            return Verdict::overlap;
        }
        for (int k = 0; k < 3 && !here.empty(); ++k) {
            const int next = surface.neighbour(c, k);
            if (next == border || next < c) { // each pair of new cells once
                continue;
            }
            const int first = surface.cell(c).corners[(k + 1) % 3];
            if (!are_apart_at_wall(here, on(next), {k, (surface.corner_of(next, first) + 1) % 3})) {
                return Verdict::overlap;
            }
        }
    }
    return Verdict::accepted;
}

} // namespace foldless
