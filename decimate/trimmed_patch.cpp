#include <foldless/decimate/trimmed_patch.h>

#include <algorithm>
#include <span>

namespace foldless {

Verdict TrimmedPatch::test(PatchedSurface& surface, PatchImage& image, const std::vector<std::int32_t>& scan_faces) {
    surface_ = &surface;
    arcs_.clear();
    for (const std::int32_t f : scan_faces) {
        const Triangle& face = scan_->faces[f];
        for (int k = 0; k < 3; ++k) {
            const std::int32_t next = face[(k + 1) % 3];
            if (topology_->border_successor(face[k]) != next) {
                continue;
            }
            // In the direction in which it is followed.
            const Verdict verdict = add({f, {std::min(face[k], next), std::max(face[k], next)}}, image);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    sort_by_triangle(arcs_);
    return are_all_apart() ? Verdict::accepted : Verdict::overlap;
}

Verdict TrimmedPatch::add(const BorderEdge& edge, PatchImage& image) {
    std::array<Corner, 2> ends{};
    for (int i = 0; i < 2; ++i) {
        const Verdict found = image.find(edge.ends[i], ends[i]);
        if (found != Verdict::accepted) {
            return found;
        }
    }
    if (ends[0].is_base_edge_to(ends[1])) {
        add_base_edge(edge, ends[0], ends[1]);
        return Verdict::accepted;
    }
    crossings_.clear();
    const Verdict verdict = image.trace(ends[0], ends[1], crossings_);
    if (verdict == Verdict::accepted) {
        add_traced(edge, {image.trace_end(ends[0], ends[1]), image.trace_end(ends[1], ends[0])});
    }
    return verdict;
}

void TrimmedPatch::add_traced(const BorderEdge& edge, const std::array<TraceEnd, 2>& ends) {
    LinePieces pieces(ends[0].cell, ends[0].at);
    for (const TraceCrossing& crossing : crossings_) {
        const int wall_of_next = (surface_->corner_of(crossing.to, crossing.edge[0]) + 1) % 3;
        pieces.cross(crossing.wall, crossing.t, crossing.to, wall_of_next);
    }
    for (const LinePiece& piece : pieces.end(ends[1].at)) {
        add_piece(edge, piece);
    }
}

/// An edge that represents itself, on the cells on both of its sides.
void TrimmedPatch::add_base_edge(const BorderEdge& edge, const Corner& from, const Corner& to) {
    for (const int cell : from.order->fan().cells) {
        const int b = surface_->corner_of(cell, to.order->vertex());
        if (b >= 0 && !surface_->cell(cell).impassable) {
            const int a = surface_->corner_of(cell, from.order->vertex());
            add_piece(
                edge,
                {cell, {{Displacement(), walls_at_corner(a)}, true}, {{Displacement(), walls_at_corner(b)}, true}});
        }
    }
}

void TrimmedPatch::add_piece(const BorderEdge& edge, const LinePiece& piece) {
    const ScanLine line{&scan_->positions[edge.ends[0]], &scan_->positions[edge.ends[1]]};
    arcs_.push_back(border_arc(surface_->cell(piece.triangle).triangle, edge, line, piece));
}

bool TrimmedPatch::are_all_apart() const {
    for (int c = 0; c < surface_->new_cells(); ++c) {
        const std::span<const BorderArc> here = arcs_on(arcs_, c);
        if (first_meeting(here) != nullptr) {
            return false;
        }
        for (int k = 0; k < 3 && !here.empty(); ++k) {
            const int next = surface_->neighbour(c, k);
            if (next == border || next < c) { // each pair of new cells once
                continue;
            }
            const int first = surface_->cell(c).corners[(k + 1) % 3];
            const CommonWall wall{k, (surface_->corner_of(next, first) + 1) % 3};
            if (first_meeting_on_wall(here, arcs_on(arcs_, next), wall) != nullptr) {
                return false;
            }
        }
    }
    return true;
}

} // namespace foldless
