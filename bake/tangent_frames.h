/// \file
/// Normals in the frames that a renderer interpolates over a textured base mesh.
#pragma once

#include <foldless/bake/split_vertices.h>
#include <foldless/bake/textured_mesh.h>

#include <foldless/predicates/vector.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace foldless {

/// The frames of a base mesh: those of its `.glb` (vertex_frames.h), interpolated.
class TangentFrames {
public:
    /// Refers to the base mesh. O(n log n).
    explicit TangentFrames(const TexturedMesh& mesh);

    /// A normal given in the axes of the base mesh, in the frame at a point of a face: to the right in the picture, up
    /// in it, and along the displacement direction; of length 1. A renderer that interpolates tangent and normal
    /// without making them unit again, as Mikkelsen (2008) does, turns it back into the direction of `normal`. (0, 0,
    /// 1) where the frame has no volume.
    [[nodiscard]] Eigen::Vector3f in_frame(std::int32_t face, const Vec3& alpha, const Eigen::Vector3f& normal) const;

private:
    SplitVertices split_;
    std::vector<Vec3> normals_; ///< of base vertices
    std::vector<Eigen::Vector4d> tangents_;
};

} // namespace foldless
