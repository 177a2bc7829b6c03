#include "random_triangles.h"

#include <foldless/predicates/barycentric.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

TEST(Barycentric, IsOneAtEachCorner) {
    const std::array<Vector2d, 3> flat{Vector2d(1, 2), Vector2d(4, 3), Vector2d(2, 7)};
    const std::array<Vec3, 3> triangle{Vec3(1, 2, 3), Vec3(4, 3, 1), Vec3(2, 7, 5)};
    const std::array<Vec3, 4> tetrahedron{Vec3(1, 2, 3), Vec3(4, 3, 1), Vec3(2, 7, 5), Vec3(0, 0, 9)};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(barycentric_in_plane(flat[i], flat), Vec3(Vec3::Unit(i)));
        EXPECT_EQ(barycentric_in_triangle(triangle[i], triangle), Vec3(Vec3::Unit(i)));
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(barycentric_in_tetrahedron(tetrahedron[i], tetrahedron), Vector4d(Vector4d::Unit(i)));
    }
}

TEST(Barycentric, RecoversThePointOfThePlane) {
    RandomTriangles random(1);
    for (int i = 0; i < 10000; ++i) {
        std::array<Vector2d, 3> triangle;
        for (Vector2d& corner : triangle) {
            corner = random.vector().head<2>();
        }
        const Vector2d point = random.vector().head<2>();
        const auto alpha = barycentric_in_plane(point, triangle);
        ASSERT_TRUE(alpha);
        ASSERT_NEAR(alpha->sum(), 1.0, 1e-15 * (1.0 + alpha->lpNorm<1>()));
        const Vector2d image = (*alpha)[0] * triangle[0] + (*alpha)[1] * triangle[1] + (*alpha)[2] * triangle[2];
        ASSERT_NEAR((image - point).norm(), 0.0, 1e-14 * (1.0 + alpha->squaredNorm()));
    }
}

TEST(Barycentric, ProjectsToThePlaneOfATriangle) {
    RandomTriangles random(2);
    for (int i = 0; i < 10000; ++i) {
        const BaseTriangle triangle = random.tame();
        const Vec3 expected = random.barycentric();
        const Vec3 normal = (triangle.v[1] - triangle.v[0]).cross(triangle.v[2] - triangle.v[0]);
        const Vec3 point = displaced(triangle, expected, 0.0) + random.number(-5, 5) * normal;
        const auto alpha = barycentric_in_triangle(point, triangle.v);
        ASSERT_TRUE(alpha);
        ASSERT_NEAR((*alpha - expected).norm(), 0.0, 1e-13);
    }
}

TEST(Barycentric, RecoversThePointOfATetrahedron) {
    RandomTriangles random(3);
    for (int i = 0; i < 10000; ++i) {
        const std::array<Vec3, 4> tetrahedron{random.vector(), random.vector(), random.vector(), random.vector()};
        const Vec3 point = random.vector();
        const auto alpha = barycentric_in_tetrahedron(point, tetrahedron);
        ASSERT_TRUE(alpha);
        ASSERT_NEAR(alpha->sum(), 1.0, 1e-15 * (1.0 + alpha->lpNorm<1>()));
        Vec3 image = Vec3::Zero();
        for (int k = 0; k < 4; ++k) {
            image += (*alpha)[k] * tetrahedron[k];
        }
        ASSERT_NEAR((image - point).norm(), 0.0, 1e-14 * (1.0 + alpha->squaredNorm()));
    }
}

TEST(Barycentric, IsNegativeBeyondAnEdge) {
    const std::array<Vector2d, 3> flat{Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1)};
    EXPECT_EQ(barycentric_in_plane(Vector2d(1, 1), flat), Vec3(-1, 1, 1));
    EXPECT_EQ(barycentric_in_plane(Vector2d(-0.5, 0.5), flat), Vec3(1, -0.5, 0.5));
}

TEST(Barycentric, DoesNotDependOnTheOrientation) {
    const std::array<Vec3, 4> left{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    const std::array<Vec3, 4> right{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)};
    EXPECT_EQ(barycentric_in_tetrahedron(Vec3(0.5, 0.25, 0.125), left), Vector4d(0.125, 0.5, 0.25, 0.125));
    EXPECT_EQ(barycentric_in_tetrahedron(Vec3(0.5, 0.25, 0.125), right), Vector4d(0.125, 0.25, 0.5, 0.125));
}

TEST(Barycentric, HasNoValueWithoutAreaOrVolume) {
    const std::array<Vector2d, 3> flat{Vector2d(0, 0), Vector2d(1, 1), Vector2d(2, 2)};
    const std::array<Vec3, 3> triangle{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
    const std::array<Vec3, 4> tetrahedron{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)};
    EXPECT_FALSE(barycentric_in_plane(Vector2d(1, 0), flat));
    EXPECT_FALSE(barycentric_in_triangle(Vec3(1, 0, 0), triangle));
    EXPECT_FALSE(barycentric_in_tetrahedron(Vec3(1, 0, 0), tetrahedron));
}

} // namespace
} // namespace foldless
