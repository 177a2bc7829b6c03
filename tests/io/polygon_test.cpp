#include <foldless/io/polygon.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace foldless {
namespace {

using Polygon = std::vector<Vec3>;

const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

Polygon regular(int corners, int step) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i * step / corners;
        polygon.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    return polygon;
}

TEST(Polygon, MayBeAnyConvexPlanarOne) {
    EXPECT_TRUE(is_convex_and_planar(square));
    EXPECT_TRUE(is_convex_and_planar(Polygon(square.rbegin(), square.rend())));
    EXPECT_TRUE(is_convex_and_planar(regular(5, 1)));
    EXPECT_TRUE(is_convex_and_planar(regular(1000, 1)));
}

TEST(Polygon, MayHaveACornerInTheMiddleOfAnEdge) {
    EXPECT_TRUE(is_convex_and_planar(Polygon{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}}));
}

TEST(Polygon, MayLeaveItsPlaneByLessThanItsFlatness) {
    const double diagonal = std::sqrt(2.0);
    // Half a corner's height is above the mean plane, half below: the spread is about the height over two.
    for (const double height : {0.5 * polygon_flatness, 5 * polygon_flatness}) {
        Polygon bent = square;
        bent[2].z() = height * diagonal;
        EXPECT_EQ(is_convex_and_planar(bent), height < polygon_flatness) << height;
    }
}

TEST(Polygon, MustBeConvex) {
    EXPECT_FALSE(is_convex_and_planar(Polygon{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}));
    // Seen from its first corner every triangle of the fan is upright, but the corner behind it is concave.
    EXPECT_FALSE(is_convex_and_planar(Polygon{{0.5, 0.5, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}}));
    EXPECT_FALSE(is_convex_and_planar(Polygon{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}));
}

TEST(Polygon, MustBeWoundOnce) {
    EXPECT_FALSE(is_convex_and_planar(regular(5, 2)));
    EXPECT_FALSE(is_convex_and_planar(regular(7, 3)));
    EXPECT_FALSE(is_convex_and_planar(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    // A spiral of two turns that turns left at every corner, and whose fan is upright all the way round.
    EXPECT_FALSE(is_convex_and_planar(
        Polygon{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {0, -3, 0}}));
}

TEST(Polygon, MustHaveAnArea) {
    EXPECT_FALSE(is_convex_and_planar(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
    EXPECT_FALSE(is_convex_and_planar(Polygon{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
    EXPECT_FALSE(is_convex_and_planar(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}})) << "there and back";
}

TEST(Polygon, IsJudgedTheSameAtEveryScale) {
    for (const int exponent : {-1000, -500, 500, 1000}) {
        Polygon large = square;
        Polygon concave{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}};
        for (std::size_t i = 0; i < 4; ++i) {
            large[i] *= std::ldexp(1.0, exponent);
            concave[i] *= std::ldexp(1.0, exponent);
        }
        EXPECT_TRUE(is_convex_and_planar(large)) << exponent;
        EXPECT_FALSE(is_convex_and_planar(concave)) << exponent;
    }
    constexpr double most = std::numeric_limits<double>::max();
    EXPECT_TRUE(is_convex_and_planar(Polygon{{-most, -most, 0}, {most, -most, 0}, {most, most, 0}, {-most, most, 0}}));
}

TEST(Polygon, WithoutFiniteCornersIsLeftToTheInspection) {
    EXPECT_TRUE(is_convex_and_planar(Polygon{{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}, {0, 1, 0}}));
}

} // namespace
} // namespace foldless
