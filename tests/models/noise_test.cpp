#include <foldless/models/noise.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foldless {
namespace {

TEST(Noise, DependsOnSeedAndIndexAlone) {
    EXPECT_EQ(noise_at(7, 1000), noise_at(7, 1000));
    EXPECT_NE(noise_at(7, 1000), noise_at(8, 1000));
    EXPECT_NE(noise_at(7, 1000), noise_at(7, 1001));
    EXPECT_NE(noise_at(7, 1000), noise_at(1000, 7));
}

TEST(Noise, HasMeanZeroVarianceOneAndABound) {
    constexpr int samples = 200'000;
    for (std::size_t component = 0; component < 3; ++component) {
        double sum = 0;
        double squares = 0;
        double greatest = 0;
        for (int i = 0; i < samples; ++i) {
            const double x = noise_at(3, static_cast<std::uint64_t>(i))[component];
            sum += x;
            squares += x * x;
            greatest = std::max(greatest, std::abs(x));
        }
        const double five_deviations = 5 / std::sqrt(static_cast<double>(samples));
        EXPECT_NEAR(sum / samples, 0, five_deviations);
        EXPECT_NEAR(squares / samples, 1, 2 * five_deviations);
        EXPECT_LT(greatest, 2 * std::numbers::sqrt3);
        EXPECT_GT(greatest, 2.5);
    }
}

TEST(Noise, NeighboursAndComponentsAreUncorrelated) {
    constexpr int samples = 200'000;
    double neighbours = 0;
    double components = 0;
    for (std::uint64_t i = 0; i < samples; ++i) {
        neighbours += noise_at(1, i)[0] * noise_at(1, i + 1)[0];
        components += noise_at(1, i)[0] * noise_at(1, i)[1];
    }
    const double five_deviations = 5 / std::sqrt(static_cast<double>(samples));
    EXPECT_NEAR(neighbours / samples, 0, five_deviations);
    EXPECT_NEAR(components / samples, 0, five_deviations);
}

} // namespace
} // namespace foldless
