#include <foldless/bake/vertex_frames.h>

#include "textured_meshes.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

constexpr double rounding = 1e-12; // of a few operations on numbers near 1

std::vector<Eigen::Vector4d> tangents(const MadeMesh& mesh) {
    return vertex_tangents(mesh.base, split_vertices(mesh.textured()), vertex_normals(mesh.base));
}

/// The third axis of the frame at the first vertex of square().
Vec3 up(const Eigen::Vector4d& tangent) {
    return Vec3::UnitZ().cross(tangent.head<3>()) * tangent.w();
}

TEST(VertexNormals, AreTheDirectionsAtUnitLength) {
    MadeMesh mesh = square();
    mesh.base.directions[1] = {0, 3e-310, 4e-310};
    mesh.base.directions[2] = {0, -3e300, 4e300};
    const std::vector<Vec3> normals = vertex_normals(mesh.base);
    EXPECT_EQ(normals[0], Vec3::UnitZ());
    EXPECT_LT((normals[1] - Vec3(0, 0.6, 0.8)).norm(), 1e-9) << "denormal numbers have few digits";
    EXPECT_LT((normals[2] - Vec3(0, -0.6, 0.8)).norm(), rounding);
}

TEST(VertexNormals, AreThoseOfTheFacesWhereThereIsNoDirection) {
    MadeMesh mesh = square();
    mesh.base.directions[0].setZero();
    mesh.base.directions[1] = {0, 1, 0};
    EXPECT_EQ(vertex_normals(mesh.base)[0], Vec3::UnitZ());
    EXPECT_EQ(vertex_normals(mesh.base)[1], Vec3::UnitY());
    mesh.base.directions.clear();
    mesh.base.positions[3].z() = 1; // the second face is 1.4 times as large and leans back
    const Vec3 first(0, 0, 1);
    const Vec3 second(1, -1, 1);
    EXPECT_LT((vertex_normals(mesh.base)[0] - (first + second).normalized()).norm(), rounding);
    EXPECT_LT((vertex_normals(mesh.base)[3] - second.normalized()).norm(), rounding);
}

TEST(VertexNormals, AreTheZAxisWhereNothingIsKnown) {
    BaseMesh base;
    base.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}};
    base.faces = {{0, 1, 2}};
    EXPECT_EQ(vertex_normals(base), std::vector<Vec3>(4, Vec3::UnitZ()));
}

TEST(VertexTangents, PointToTheRightInThePicture) {
    for (const Eigen::Vector4d& tangent : tangents(square())) {
        EXPECT_LT((tangent - Eigen::Vector4d(1, 0, 0, 1)).norm(), rounding);
        EXPECT_LT((up(tangent) - Vec3::UnitY()).norm(), rounding);
    }
}

TEST(VertexTangents, TurnWithThePicture) {
    MadeMesh mesh = square();
    for (auto& corners : mesh.uv) {
        for (Eigen::Vector2d& uv : corners) {
            uv = {uv.y(), 1 - uv.x()}; // right in the picture is -y on the square, and up is x
        }
    }
    for (const Eigen::Vector4d& tangent : tangents(mesh)) {
        EXPECT_LT((tangent - Eigen::Vector4d(0, -1, 0, 1)).norm(), rounding);
        EXPECT_LT((up(tangent) - Vec3::UnitX()).norm(), rounding);
    }
}

TEST(VertexTangents, TellAMirroredPicture) {
    MadeMesh mesh = square();
    for (auto& corners : mesh.uv) {
        for (Eigen::Vector2d& uv : corners) {
            uv.x() = 1 - uv.x();
        }
    }
    for (const Eigen::Vector4d& tangent : tangents(mesh)) {
        EXPECT_LT((tangent - Eigen::Vector4d(-1, 0, 0, -1)).norm(), rounding);
        EXPECT_LT((up(tangent) - Vec3::UnitY()).norm(), rounding);
    }
}

TEST(VertexTangents, AreAtARightAngleToTheNormal) {
    const MadeMesh mesh = cut_grid(5);
    const SplitVertices split = split_vertices(mesh.textured());
    const std::vector<Vec3> normals = vertex_normals(mesh.base);
    const std::vector<Eigen::Vector4d> all = vertex_tangents(mesh.base, split, normals);
    for (std::size_t vertex = 0; vertex < all.size(); ++vertex) {
        EXPECT_NEAR(all[vertex].head<3>().dot(normals[split.base_vertex[vertex]]), 0, rounding);
        EXPECT_NEAR(all[vertex].head<3>().norm(), 1, rounding);
        EXPECT_GT(all[vertex].x(), 0.5) << "u grows with x";
        EXPECT_EQ(all[vertex].w(), 1);
    }
}

TEST(VertexTangents, CountFacesByTheirAngle) {
    // Two faces at vertex 0 with angles of 90 and 45 degrees, and pictures that are turned by 90 degrees.
    MadeMesh mesh = square();
    mesh.base.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
    mesh.base.faces = {{0, 1, 2}, {0, 2, 3}};
    mesh.uv = {{{{0, 1}, {1, 1}, {0, 0}}}, {{{0, 1}, {1, 1}, {1, 0}}}}; // right: x axis; y axis
    const Vec3 expected = Vec3(2, 1, 0).normalized();
    EXPECT_LT((tangents(mesh)[0].head<3>() - expected).norm(), rounding);
}

TEST(VertexTangents, AreOfUnitLengthWhateverTheMesh) {
    const MadeMesh mesh = degenerate_mesh();
    const SplitVertices split = split_vertices(mesh.textured());
    const std::vector<Vec3> normals = vertex_normals(mesh.base);
    const std::vector<Eigen::Vector4d> all = vertex_tangents(mesh.base, split, normals);
    for (std::size_t vertex = 0; vertex < all.size(); ++vertex) {
        EXPECT_NEAR(normals[split.base_vertex[vertex]].norm(), 1, rounding);
        EXPECT_NEAR(all[vertex].head<3>().norm(), 1, rounding);
        EXPECT_NEAR(all[vertex].head<3>().dot(normals[split.base_vertex[vertex]]), 0, rounding);
        EXPECT_EQ(std::abs(all[vertex].w()), 1);
    }
}

TEST(VertexTangents, AreAnyWhereThePictureIsAlongTheNormal) {
    MadeMesh mesh = square();
    mesh.base.directions.assign(4, Vec3(3, 0, 0)); // right in the picture
    for (const Eigen::Vector4d& tangent : tangents(mesh)) {
        EXPECT_NEAR(tangent.x(), 0, rounding);
        EXPECT_NEAR(tangent.head<3>().norm(), 1, rounding);
        EXPECT_EQ(tangent.w(), 1);
    }
}

} // namespace
} // namespace foldless
