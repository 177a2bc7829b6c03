#include <foldless/bake/tangent_frames.h>

#include <foldless/bake/vertex_frames.h>

#include <cmath>

namespace foldless {

TangentFrames::TangentFrames(const TexturedMesh& mesh)
    : split_(split_vertices(mesh)), normals_(vertex_normals(*mesh.base)),
      tangents_(vertex_tangents(*mesh.base, split_, normals_)) {}

Eigen::Vector3f TangentFrames::in_frame(std::int32_t face, const Vec3& alpha, const Eigen::Vector3f& normal) const {
    Vec3 up = Vec3::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t corner = split_.faces[face][k];
        up += alpha[k] * normals_[split_.base_vertex[corner]];
        right += alpha[k] * tangents_[corner];
    }
    const Vec3 t = right.head<3>();
    const Vec3 b = right.w() * up.cross(t);
    // The weights x, y, z with x t + y b + z up = normal, times the volume, by Cramer's rule.
    const Vec3 n = normal.cast<double>();
    const double volume = t.cross(b).dot(up);
    Vec3 weights(n.cross(b).dot(up), t.cross(n).dot(up), t.cross(b).dot(n));
    weights *= std::copysign(1.0, volume);
    const double length = weights.norm();
    return volume != 0.0 && length > 0.0 ? Eigen::Vector3f((weights / length).cast<float>()) : Eigen::Vector3f(0, 0, 1);
}

} // namespace foldless
