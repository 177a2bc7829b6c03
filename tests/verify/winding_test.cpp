#include <foldless/verify/winding.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foldless::verification {
namespace {

/// `edges` edges that turn by equal angles, `turns` turns in all from the first to the last.
Star star(int edges, double turns, bool closed) {
    Star result{{0.1, 0.2, 1}, {}, closed};
    for (int k = 0; k < edges; ++k) {
        const double angle = 2 * std::numbers::pi * turns * k / (closed ? edges : edges - 1);
        result.edges.emplace_back(std::cos(angle), std::sin(angle), 0.3 * std::sin(3 * angle));
    }
    return result;
}

TEST(Winding, TellsOneTurnFromTwo) {
    for (int edges = 3; edges < 12; ++edges) {
        EXPECT_EQ(goes_round_once(star(edges, 1, true)), Sign::positive);
    }
    for (int edges = 5; edges < 12; ++edges) {
        EXPECT_NE(goes_round_once(star(edges, 2, true)), Sign::positive);
    }
    EXPECT_EQ(goes_round_once(star(5, 2, true)), Sign::negative);
    EXPECT_EQ(goes_round_once(star(7, 3, true)), Sign::negative);
}

TEST(Winding, LetsAnOpenStarGoLessThanRound) {
    EXPECT_EQ(goes_round_once(star(2, 0.25, false)), Sign::positive);
    EXPECT_EQ(goes_round_once(star(6, 0.95, false)), Sign::positive);
    EXPECT_EQ(goes_round_once(star(6, 1.1, false)), Sign::negative);
}

TEST(Winding, AllowsEdgesOppositeTheFirst) {
    const Star cross{{0, 0, 1}, {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, true};
    EXPECT_EQ(goes_round_once(cross), Sign::positive);
}

} // namespace
} // namespace foldless::verification
