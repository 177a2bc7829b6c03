/// \file
/// The surface of a solid made of boxes, as patches.
#pragma once

#include <foldless/models/quilt.h>

#include <array>
#include <vector>

namespace foldless {

/// The cuts across one axis, ascending, and the weight of each interval between two cuts.
struct BlockAxis {
    std::vector<double> cuts;
    std::vector<int> weights;
};

/// A rectilinear grid, some of whose boxes are filled; a box is named by its intervals on the three axes.
struct Blocks {
    std::array<BlockAxis, 3> axes;
    std::vector<std::array<int, 3>> filled;
};

/// The boundary of the filled boxes, oriented outward. Corners are numbered by z, then y, then x.
struct BlockSurface {
    std::vector<QuiltPatch> patches;
    std::vector<Vec3> corners;

    /// The point of a place, bilinear on its patch.
    [[nodiscard]] Vec3 point(const SurfacePlace& place) const;
};

/// Time O(boxes log boxes).
[[nodiscard]] BlockSurface surface_of(const Blocks& blocks);

} // namespace foldless
