/// \file
/// Small meshes with texture coordinates, written out.
#pragma once

#include <foldless/bake/textured_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace foldless {

/// A textured mesh with the base mesh that it stands on.
struct MadeMesh {
    BaseMesh base;
    std::vector<std::array<Eigen::Vector2d, 3>> uv;

    [[nodiscard]] TexturedMesh textured() const { return {&base, uv}; }
};

/// The unit square in the plane z = 0 as two faces, seen from above, with the picture upright on it.
[[nodiscard]] MadeMesh square();

/// A bumpy grid of `cells` x `cells` squares whose picture is cut in two along a line in the middle, and whose numbers
/// are thirds and the like. Directions have different lengths.
[[nodiscard]] MadeMesh cut_grid(int cells);

/// So many triangles that share nothing.
[[nodiscard]] MadeMesh loose_triangles(int count);

/// A mesh of which nothing is as it should be: faces without area, in space or in the picture; directions that are
/// zero, tiny or huge; pictures mirrored, or along the direction.
[[nodiscard]] MadeMesh degenerate_mesh();

/// A picture of one pixel as a PNG file.
[[nodiscard]] std::string one_pixel_png();

} // namespace foldless
