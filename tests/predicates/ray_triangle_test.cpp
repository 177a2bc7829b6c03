#include "random_triangles.h"

#include <foldless/predicates/ray_triangle.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// Counterclockwise seen from above: its front is up.
const ScanTriangle floor_triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

TEST(RayTriangle, GivesDisplacementAndCoordinates) {
    const auto hit = intersection({Vec3(0.25, 0.5, -3), Vec3(0, 0, 1)}, floor_triangle);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 3.0);
    EXPECT_EQ(hit->u, 0.25);
    EXPECT_EQ(hit->v, 0.5);
}

TEST(RayTriangle, MeasuresInUnitsOfTheDirection) {
    const auto hit = intersection({Vec3(0.25, 0.5, -3), Vec3(0, 0, 2)}, floor_triangle);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 1.5);
}

TEST(RayTriangle, MeetsBothSidesAndTellsWhich) {
    const auto leaving = intersection({Vec3(0.25, 0.25, -1), Vec3(0, 0, 1)}, floor_triangle);
    const auto entering = intersection({Vec3(0.25, 0.25, 1), Vec3(0, 0, -1)}, floor_triangle);
    ASSERT_TRUE(leaving);
    ASSERT_TRUE(entering);
    EXPECT_EQ(leaving->facing, 1.0);
    EXPECT_EQ(entering->facing, -1.0);
}

TEST(RayTriangle, MeetsWhatLiesBehind) {
    const auto hit = intersection({Vec3(0.25, 0.25, 2), Vec3(0, 0, 1)}, floor_triangle);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, -2.0);
    EXPECT_GT(hit->facing, 0.0);
}

TEST(RayTriangle, IncludesTheBorderAndNothingBeyond) {
    for (const Vec3& corner : floor_triangle) {
        EXPECT_TRUE(intersection({corner - Vec3(0, 0, 1), Vec3(0, 0, 1)}, floor_triangle));
    }
    EXPECT_TRUE(intersection({Vec3(0.5, 0.5, -1), Vec3(0, 0, 1)}, floor_triangle));
    EXPECT_FALSE(intersection({Vec3(0.5, 0.5 + 0x1p-50, -1), Vec3(0, 0, 1)}, floor_triangle));
    EXPECT_FALSE(intersection({Vec3(-0x1p-50, 0.5, -1), Vec3(0, 0, 1)}, floor_triangle));
    EXPECT_FALSE(intersection({Vec3(0.5, -0x1p-50, -1), Vec3(0, 0, 1)}, floor_triangle));
}

TEST(RayTriangle, MissesParallelRaysDegenerateTrianglesAndNaN) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(intersection({Vec3(0, 0, 1), Vec3(1, 1, 0)}, floor_triangle));
    EXPECT_FALSE(intersection({Vec3(0, 0, 0), Vec3(1, 1, 0)}, floor_triangle));
    EXPECT_FALSE(intersection({Vec3(0, 0, 1), Vec3(0, 0, 0)}, floor_triangle));
    EXPECT_FALSE(intersection({Vec3(0, 0, 1), Vec3(0, 0, 1)}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}));
    EXPECT_FALSE(intersection({Vec3(nan, 0, 1), Vec3(0, 0, 1)}, floor_triangle));
}

// A threshold on the determinant, as in the original, would lose small triangles.
TEST(RayTriangle, MeetsATinyTriangle) {
    ScanTriangle tiny = floor_triangle;
    for (Vec3& corner : tiny) {
        corner *= 0x1p-300;
    }
    const auto hit = intersection({Vec3(0x1p-302, 0x1p-302, -1), Vec3(0, 0, 1)}, tiny);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->u, 0.25);
    EXPECT_EQ(hit->t, 1.0);
}

TEST(RayTriangle, FindsAPointAimedAt) {
    RandomTriangles random(1);
    for (int i = 0; i < 50000; ++i) {
        const ScanTriangle triangle = random.tame().v;
        const Vec3 alpha = random.barycentric();
        const Vec3 target = displaced({triangle, triangle}, alpha, 0.0);
        const Vec3 direction = random.vector();
        const double t = random.number(-3, 3);
        const auto hit = intersection({target - t * direction, direction}, triangle);
        const double facing = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).dot(direction);
        if (std::abs(facing) > 1e-2 && alpha.minCoeff() > 1e-6) {
            ASSERT_TRUE(hit) << i;
            ASSERT_NEAR(hit->t, t, 1e-12);
            ASSERT_NEAR(hit->u, alpha[1], 1e-12);
            ASSERT_NEAR(hit->v, alpha[2], 1e-12);
            ASSERT_NEAR(hit->facing, facing, 1e-14);
        }
    }
}

} // namespace
} // namespace foldless
