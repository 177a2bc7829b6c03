/// \file
/// A base mesh that pictures are laid on.
#pragma once

#include <foldless/io/base_mesh.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace foldless {

/// A base mesh with texture coordinates. They belong to the corners of faces, not to vertices: at a seam the faces
/// around a vertex lie in different places of the picture.
struct TexturedMesh {
    const BaseMesh* base;
    /// One for each face, for its corners in order: u to the right, v *down* from the top row of the picture, 0 to 1.
    std::vector<std::array<Eigen::Vector2d, 3>> uv;
};

} // namespace foldless
