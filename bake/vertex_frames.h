/// \file
/// The frames that a normal map is read in: a normal and a tangent for each vertex.
#pragma once

#include <foldless/bake/split_vertices.h>

#include <vector>

namespace foldless {

/// A unit normal for each base vertex: the displacement direction, normalised. Where that is zero, or the base mesh has
/// none, the mean normal of the faces weighted by area; and where that is zero too, the z axis. O(vertices + faces).
[[nodiscard]] std::vector<Vec3> vertex_normals(const BaseMesh& base);

/// A unit tangent for each split vertex, at a right angle to its normal, and in the fourth number w the side of the
/// third axis: normal x tangent * w. The tangent points to the right in the picture, the third axis *up*, as glTF has
/// it; w is -1 where the picture lies mirrored on the mesh (or on most of the faces around). Each face around the
/// vertex counts by its angle there, as in Mikkelsen 2008. A face without area in the picture counts nothing, and where
/// all are such, or cancel out, the tangent is any at a right angle, with w = 1. `normals` are those of the base
/// vertices. O(vertices + faces).
[[nodiscard]] std::vector<Eigen::Vector4d> vertex_tangents(const BaseMesh& base, const SplitVertices& split,
                                                           const std::vector<Vec3>& normals);

} // namespace foldless
