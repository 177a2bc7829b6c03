#include <foldless/io/float32.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foldless {
namespace {

constexpr double largest = std::numeric_limits<float>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Float32, RoundsToBothSides) {
    for (const double value : {0.1, -0.1, 1e-50, -1e-50, 3.0, 0.0, largest, -largest}) {
        EXPECT_TRUE(is_float32(float32_above(value)));
        EXPECT_TRUE(is_float32(float32_below(value)));
        EXPECT_LE(float32_below(value), value);
        EXPECT_GE(float32_above(value), value);
        EXPECT_EQ(float32_below(value) == value, is_float32(value));
        EXPECT_EQ(float32_above(value) == value, is_float32(value));
        EXPECT_TRUE(to_float32(value) == float32_above(value) || to_float32(value) == float32_below(value));
    }
}

TEST(Float32, IsInfiniteBeyondTheLargest) {
    for (const double value : {std::nextafter(largest, infinity), 1e39, 1e300, infinity}) {
        EXPECT_EQ(to_float32(value), infinity);
        EXPECT_EQ(to_float32(-value), -infinity);
        EXPECT_EQ(float32_above(value), infinity);
        EXPECT_EQ(float32_below(-value), -infinity);
        EXPECT_EQ(is_float32(value), std::isinf(value));
    }
    EXPECT_EQ(float32_below(1e300), largest);
    EXPECT_EQ(float32_above(-1e300), -largest);
    EXPECT_FALSE(is_float32(std::numeric_limits<double>::quiet_NaN()));
}

} // namespace
} // namespace foldless
