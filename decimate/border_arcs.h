/// \file
/// Condition T1 of docs/certificate.md on a patch: the images of trimmed borders do not meet.
#pragma once

#include <foldless/decimate/edge_trace.h>
#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/line_pieces.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// A side of a scan face on the scan's border.
struct BorderEdge {
    std::int32_t scan_face;
    std::array<std::int32_t, 2> ends; ///< scan vertices
};

/// The images of border edges on the cells of a patched surface.
class BorderArcs {
public:
    void clear() { arcs_.clear(); }

    /// Adds the pieces of an edge. Refers to the points at both ends.
    void add(const PatchedSurface& surface, const BorderEdge& edge, const TracedEdge& traced);
    /// Adds one piece of an edge, on the cell that it names.
    void add(const PatchedSurface& surface, const BorderEdge& edge, const LinePiece& piece, const ScanLine& line);

    /// `overlap` unless the arcs on each new cell, and at its walls, certainly meet at common vertices only.
    [[nodiscard]] Verdict test(PatchedSurface& surface);

private:
    struct Arc {
        int cell;
        std::int32_t scan_face;
        std::array<std::int32_t, 2> vertices; ///< scan vertices at its ends, or -1 on a wall
        ImageArc image;
    };
    [[nodiscard]] std::span<const Arc> on(int cell) const;
    [[nodiscard]] static bool are_apart_in_cell(std::span<const Arc> arcs);
    [[nodiscard]] static bool are_apart_at_wall(std::span<const Arc> here, std::span<const Arc> there,
                                                const CommonWall& wall);

    std::vector<Arc> arcs_; ///< for test(), by cell, then by the lower bound of alpha_0
};

} // namespace foldless
