#include <foldless/bake/tangent_frames.h>

#include <foldless/bake/vertex_frames.h>

#include "textured_meshes.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace foldless {
namespace {

/// What a renderer makes of a normal in the frame: interpolated axes, not made unit again.
Vec3 rendered(const MadeMesh& mesh, std::size_t face, const Vec3& alpha, const Eigen::Vector3f& stored) {
    const SplitVertices split = split_vertices(mesh.textured());
    const std::vector<Vec3> normals = vertex_normals(mesh.base);
    const std::vector<Eigen::Vector4d> tangents = vertex_tangents(mesh.base, split, normals);
    Vec3 n = Vec3::Zero();
    Eigen::Vector4d t = Eigen::Vector4d::Zero();
    for (int k = 0; k < 3; ++k) {
        n += alpha[k] * normals[split.base_vertex[split.faces[face][k]]];
        t += alpha[k] * tangents[split.faces[face][k]];
    }
    const Vec3 b = t.w() * n.cross(t.head<3>());
    return (stored.x() * t.head<3>() + stored.y() * b + stored.z() * n).normalized();
}

TEST(TangentFrames, GiveTheNormalBack) {
    const MadeMesh mesh = cut_grid(4);
    const TangentFrames frames(mesh.textured());
    const Vec3 normal = Vec3(0.3, -0.4, 0.8).normalized();
    for (std::size_t face = 0; face < mesh.base.faces.size(); ++face) {
        for (const Vec3& alpha : {Vec3(1, 0, 0), Vec3(0.2, 0.5, 0.3), Vec3(-0.1, 0.4, 0.7)}) {
            const auto stored = frames.in_frame(static_cast<std::int32_t>(face), alpha, normal.cast<float>());
            EXPECT_NEAR(stored.norm(), 1.0, 1e-6);
            EXPECT_LT((rendered(mesh, face, alpha, stored) - normal).norm(), 1e-5) << face;
        }
    }
}

TEST(TangentFrames, GoRightUpAndOut) {
    const MadeMesh mesh = square();
    const TangentFrames frames(mesh.textured());
    const Vec3 alpha(0.25, 0.25, 0.5);
    EXPECT_EQ(frames.in_frame(0, alpha, {1, 0, 0}), Eigen::Vector3f(1, 0, 0));
    EXPECT_EQ(frames.in_frame(1, alpha, {0, 1, 0}), Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(frames.in_frame(0, alpha, {0, 0, 1}), Eigen::Vector3f(0, 0, 1));
}

TEST(TangentFrames, TurnWithMirroredPictures) {
    MadeMesh mesh = square();
    for (auto& corners : mesh.uv) {
        for (Eigen::Vector2d& uv : corners) {
            uv.x() = 1 - uv.x();
        }
    }
    const TangentFrames frames(mesh.textured());
    const Eigen::Vector3f stored = frames.in_frame(0, {0.25, 0.25, 0.5}, {0.6F, 0.8F, 0});
    EXPECT_LT((stored - Eigen::Vector3f(-0.6F, 0.8F, 0)).norm(), 1e-6F);
}

TEST(TangentFrames, AreStraightOutWhereThereIsNoFrame) {
    MadeMesh mesh = square();
    mesh.base.directions[0] = {0, 0, -1}; // opposite to that of the corner 1
    const TangentFrames frames(mesh.textured());
    EXPECT_EQ(frames.in_frame(0, {0.5, 0.5, 0}, {1, 0, 0}), Eigen::Vector3f(0, 0, 1));
    const MadeMesh degenerate = degenerate_mesh();
    const TangentFrames broken(degenerate.textured());
    for (std::size_t face = 0; face < degenerate.base.faces.size(); ++face) {
        const auto stored = broken.in_frame(static_cast<std::int32_t>(face), {0.5, 0.25, 0.25}, {0, 0.6F, 0.8F});
        EXPECT_NEAR(stored.norm(), 1.0, 1e-5) << face;
    }
}

} // namespace
} // namespace foldless
