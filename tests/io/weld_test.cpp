#include <foldless/io/weld.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foldless {
namespace {

using Indices = std::vector<std::int32_t>;

TEST(Weld, NumbersPositionsInOrderOfFirstAppearance) {
    const std::vector<Vec3> corners{{2, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Welded welded = weld(corners);
    EXPECT_EQ(welded.indices, (Indices{0, 1, 0, 2, 1, 0}));
    EXPECT_EQ(welded.positions, (std::vector<Vec3>{{2, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
}

TEST(Weld, TakesMinusZeroForZero) {
    const Welded welded = weld(std::vector<Vec3>{{-0.0, 1, 0.0}, {0.0, 1, -0.0}});
    EXPECT_EQ(welded.indices, (Indices{0, 0}));
    EXPECT_TRUE(std::signbit(welded.positions[0].x())) << "the first of them keeps its bits";
}

TEST(Weld, KeepsNeighbouringNumbersApart) {
    const std::vector<Vec3> corners{{1, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}, {1, 0, 5e-324}};
    EXPECT_EQ(weld(corners).indices, (Indices{0, 1, 2}));
}

TEST(Weld, EndsWithNumbersThatHaveNoOrder) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> corners{{nan, 0, 0}, {1, nan, 0}, {nan, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(weld(corners).indices, (Indices{0, 1, 0, 2}));
    EXPECT_TRUE(weld(std::vector<Vec3>{}).positions.empty());
}

} // namespace
} // namespace foldless
