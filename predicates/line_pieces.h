/// \file
/// The pieces of a scan line over the base triangles on its way.
#pragma once

#include <foldless/predicates/image_arc.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// The part of a line over one triangle.
struct LinePiece {
    std::int32_t triangle; ///< as the caller numbers them
    ImageArc::End from;
    ImageArc::End to;
};

/// Collects them, from the line's one end to its other.
class LinePieces {
public:
    LinePieces(std::int32_t triangle, const PrismoidPoint& start);

    /// The line goes out through a wall of the triangle and into the next one.
    void cross(int wall, const Displacement& t, std::int32_t next, int wall_of_next);

    /// All pieces. An end on a wall may belong to a triangle in which nothing else of the line lies: no piece is made
    /// of that point alone.
    [[nodiscard]] std::vector<LinePiece> end(const PrismoidPoint& at);

private:
    std::vector<LinePiece> pieces_;
};

} // namespace foldless
