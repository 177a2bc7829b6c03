#include <foldless/io/zero_area.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

ScanTriangle scaled(const ScanTriangle& t, double factor) {
    return {t[0] * factor, t[1] * factor, t[2] * factor};
}

TEST(ZeroArea, HoldsForCornersOnOneLine) {
    EXPECT_TRUE(has_zero_area({Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(3, 6, 9)}));
    EXPECT_TRUE(has_zero_area({Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(5, 0, 0)}));
    EXPECT_TRUE(has_zero_area({Vec3(7, 7, 7), Vec3(7, 7, 7), Vec3(7, 7, 7)}));
}

TEST(ZeroArea, IsNotFooledByOneUnitInTheLastPlace) {
    const double above = std::nextafter(3.0, 4.0);
    EXPECT_FALSE(has_zero_area({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, above)}));
    // Far from the origin the differences are small numbers without error, but their products are not.
    EXPECT_FALSE(has_zero_area({Vec3(1e6, 1e6, 0), Vec3(1e6 + 1, 1e6 + 1, 0), Vec3(2e6, std::nextafter(2e6, 3e6), 0)}));
}

// In decimals these lie on one line; the doubles nearest to them do not: 0.1 + 0.2 is not 0.3.
TEST(ZeroArea, TakesTheDoublesForWhatTheyAre) {
    EXPECT_FALSE(has_zero_area({Vec3(0, 0, 0), Vec3(0.1, 0.3, 0), Vec3(0.2, 0.6, 0) + Vec3(0.1, 0, 0)}));
    EXPECT_FALSE(has_zero_area({Vec3(0, 0, 0), Vec3(0.1, 1, 0), Vec3(0.3, 3, 0)}));
    EXPECT_TRUE(has_zero_area({Vec3(0, 0, 0), Vec3(0.1, 1, 0), Vec3(0.2, 2, 0)}));
}

TEST(ZeroArea, DoesNotDependOnTheScale) {
    const ScanTriangle flat{Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(3, 6, 9)};
    const ScanTriangle thin{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, std::nextafter(3.0, 4.0))};
    for (const int exponent : {-1000, -700, -500, -100, 100, 500, 1000}) {
        const double factor = std::ldexp(1.0, exponent);
        EXPECT_TRUE(has_zero_area(scaled(flat, factor))) << exponent;
        EXPECT_FALSE(has_zero_area(scaled(thin, factor))) << exponent;
    }
}

TEST(ZeroArea, ReachesTheSmallestNumbers) {
    constexpr double least = 5e-324;
    EXPECT_FALSE(has_zero_area({Vec3(0, 0, 0), Vec3(least, 0, 0), Vec3(0, least, 0)}));
    EXPECT_TRUE(has_zero_area({Vec3(0, 0, 0), Vec3(least, least, 0), Vec3(2 * least, 2 * least, 0)}));
}

} // namespace
} // namespace foldless
