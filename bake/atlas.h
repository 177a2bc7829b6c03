/// \file
/// A picture with one chart for each base face.
#pragma once

#include <foldless/bake/sample_lattice.h>

#include <foldless/io/base_mesh.h>
#include <foldless/predicates/vector.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace foldless {

/// Where the samples of a base face are in the picture: a right triangle with its legs along the texels, so that
/// samples lie on both legs. The corner at the right angle is the one opposite the longest edge of the face; the next
/// corner lies to its right, and the one after above it, or both turned by half a turn.
///
///      row y - rows   2 o
///                       | \                                                                                         .
///             row y   0 o---o 1      0, 1, 2: the corners `corner`, corner + 1, corner + 2 (mod 3) of the face
///               column x     x + columns
struct Chart {
    int corner = 0;
    SampleLattice lattice;
    int x = 0; ///< column of the texel of the corner at the right angle
    int y = 0; ///< row from the top
    bool turned = false;

    /// Column and row of sample (i, j), which may lie outside the triangle.
    [[nodiscard]] std::array<int, 2> texel(int i, int j) const {
        return turned ? std::array{x - i, y + j} : std::array{x + i, y - j};
    }
};

/// A square picture in which each base face has a chart, two in a rectangle; around each chart is a gutter, and no
/// texel belongs to two.
struct Atlas {
    int size = 0;   ///< texels on a side
    int gutter = 0; ///< texels
    std::vector<Chart> charts;

    /// Texture coordinates of a corner of a face, u to the right and v downwards from 0 to 1.
    [[nodiscard]] Eigen::Vector2d coordinates(std::int32_t face, int corner) const;
};

/// Those of the corners of each face, in order.
[[nodiscard]] std::vector<std::array<Eigen::Vector2d, 3>> texture_coordinates(const Atlas& atlas);

/// There is no room for all charts.
class AtlasTooSmall : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

struct AtlasOptions {
    int size = 2048; ///< texels on a side
    int gutter = 2;  ///< texels around each chart that hold extrapolated values, at least 1
};

/// Charts as large as fit, with the same number of texels per length everywhere, at least one texel along each leg.
/// The rectangles are packed by stb_rect_pack. The same mesh gives the same atlas.
/// \throws AtlasTooSmall if even the smallest charts do not fit. Time O(f log f) for f faces, about twenty times.
[[nodiscard]] Atlas make_atlas(const BaseMesh& base, const AtlasOptions& options);

} // namespace foldless
