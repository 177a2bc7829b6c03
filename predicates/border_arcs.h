/// \file
/// The images of a scan's borders on base triangles, and which of them may meet: condition T1 of docs/certificate.md.
#pragma once

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

/// The image of a piece of a border edge.
struct BorderArc {
    std::int32_t triangle; ///< as the caller numbers them
    BorderEdge edge;
    std::array<std::int32_t, 2> vertices; ///< scan vertices at its ends, or -1 on a wall
    ImageArc image;
};

/// The image of a piece of the edge along the line, on the triangle that the piece names.
[[nodiscard]] BorderArc border_arc(const BaseTriangle& triangle, const BorderEdge& edge, const ScanLine& line,
                                   const LinePiece& piece);

/// Orders arcs by triangle, and on each triangle as first_meeting() needs them.
void sort_by_triangle(std::vector<BorderArc>& arcs);

/// Those on one triangle. \pre the arcs are sorted
[[nodiscard]] std::span<const BorderArc> arcs_on(const std::vector<BorderArc>& arcs, std::int32_t triangle);

/// The first arc that is not certainly apart from another on the same triangle, but for common vertices; or null. Edges
/// of one scan face are not asked: its border is a simple curve (theorem B). \pre the arcs are sorted
[[nodiscard]] const BorderArc* first_meeting(std::span<const BorderArc> arcs);

/// The same for arcs on two neighbouring triangles, which can meet on the common wall where neither crosses it.
[[nodiscard]] const BorderArc* first_meeting_on_wall(std::span<const BorderArc> a, std::span<const BorderArc> b,
                                                     const CommonWall& wall);

} // namespace foldless
