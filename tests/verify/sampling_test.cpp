#include <foldless/verify/sampling.h>

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace foldless::verification {
namespace {

TEST(Sampling, PutsPointsInsideTheTriangle) {
    for (int i = 0; i < 1000; ++i) {
        for (const Vec3& alpha : {low_discrepancy_point(3, i), stratified_point(3, 32, i)}) {
            EXPECT_GE(alpha.minCoeff(), 0.0);
            EXPECT_NEAR(alpha.sum(), 1.0, 1e-15);
        }
    }
}

TEST(Sampling, SpreadsPointsEvenly) {
    Vec3 mean = Vec3::Zero();
    constexpr int points = 1000;
    for (int i = 0; i < points; ++i) {
        mean += low_discrepancy_point(11, i) / points;
    }
    EXPECT_LT((mean - Vec3::Constant(1.0 / 3)).norm(), 0.01);
    EXPECT_NE(low_discrepancy_point(11, 0), low_discrepancy_point(12, 0));
}

/// The subtriangle that holds a point: its row from corner 0, its column, and which way it points.
std::array<int, 3> cell_of(const Vec3& alpha, int side) {
    const double down = (1 - alpha[0]) * side;
    const double along = alpha[2] * side;
    const double back = alpha[1] * side;
    return {static_cast<int>(down), static_cast<int>(along), static_cast<int>(back)};
}

TEST(Sampling, PutsOnePointIntoEverySubtriangle) {
    constexpr int side = 8;
    std::set<std::array<int, 3>> cells;
    for (int i = 0; i < side * side; ++i) {
        cells.insert(cell_of(stratified_point(5, side, i), side));
    }
    EXPECT_EQ(cells.size(), side * side);
}

} // namespace
} // namespace foldless::verification
