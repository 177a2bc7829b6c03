#include <foldless/decimate/vertex_directions.h>
#include <foldless/io/float32.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace foldless {
namespace {

TEST(VertexNormal, WeighsByAreaOrByAngle) {
    // At the origin: a right angle in the plane z = 0 with legs 1, and one in the plane x = 0 with legs 1 and 3.
    const std::vector<std::array<Vec3, 3>> star{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                                {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 3)}};
    const auto area = vertex_normal(star, Directions::area);
    ASSERT_TRUE(area);
    EXPECT_NEAR((*area - Vec3(3, 0, 1).normalized()).norm(), 0, 1e-15);
    const auto angle = vertex_normal(star, Directions::angle);
    ASSERT_TRUE(angle);
    EXPECT_NEAR((*angle - Vec3(1, 0, 1).normalized()).norm(), 0, 1e-15);
}

// The only way to the verdict `direction`: a star whose normals cancel exactly.
TEST(VertexNormal, IsNothingWhereTheNormalsCancel) {
    const std::array<Vec3, 3> face{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const std::vector<std::array<Vec3, 3>> both_sides{face, {face[0], face[2], face[1]}};
    EXPECT_FALSE(vertex_normal(both_sides, Directions::area));
    EXPECT_FALSE(vertex_normal(both_sides, Directions::angle));
    EXPECT_FALSE(vertex_normal({}, Directions::area));
    EXPECT_TRUE(vertex_normal(std::vector{face}, Directions::area));
}

TEST(StoredDirection, IsAFloat32ValueOfUnitLength) {
    const Vec3 stored = stored_direction({1, 2, 3});
    EXPECT_TRUE(is_float32(stored));
    EXPECT_NEAR((stored - Vec3(1, 2, 3).normalized()).norm(), 0, 1e-7);
}

} // namespace
} // namespace foldless
