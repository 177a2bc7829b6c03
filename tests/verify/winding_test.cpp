#include <foldless/verify/winding.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace foldless::verification {
namespace {

/// `edges` edges that turn by equal angles, `turns` turns in all from the first to the last.
Star star(int edges, double turns, bool closed) {
    Star result{{{1, 2, 3}, {0.1, 0.2, 1}}, {}, closed};
    for (int k = 0; k < edges; ++k) {
        const double angle = 2 * std::numbers::pi * turns * k / (closed ? edges : edges - 1);
        const Vec3 edge(std::cos(angle), std::sin(angle), 0.3 * std::sin(3 * angle));
        result.ends.push_back({result.centre.v + edge, Vec3::Zero()});
    }
    return result;
}

TEST(Winding, TellsOneTurnFromTwo) {
    for (int edges = 3; edges < 12; ++edges) {
        EXPECT_TRUE(goes_round_once(star(edges, 1, true)));
    }
    for (int edges = 5; edges < 12; ++edges) {
        EXPECT_FALSE(goes_round_once(star(edges, 2, true)));
    }
    EXPECT_FALSE(goes_round_once(star(5, 2, true)));
    EXPECT_FALSE(goes_round_once(star(7, 3, true)));
}

TEST(Winding, LetsAnOpenStarGoLessThanRound) {
    EXPECT_TRUE(goes_round_once(star(2, 0.25, false)));
    EXPECT_TRUE(goes_round_once(star(6, 0.95, false)));
    EXPECT_FALSE(goes_round_once(star(6, 1.1, false)));
}

TEST(Winding, AllowsEdgesOppositeTheFirst) {
    Star cross{{Vec3::Zero(), Vec3::UnitZ()}, {}, true};
    for (const Vec3& end : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}) {
        cross.ends.push_back({end, Vec3::Zero()});
    }
    EXPECT_TRUE(goes_round_once(cross));
}

// A pentagram at t = 0, whose ends move to a pentagon until t = 1.
TEST(Winding, IsAskedAtTheDisplacement) {
    const Star pentagram = star(5, 2, true);
    Star moving = pentagram;
    for (std::size_t k = 0; k < 5; ++k) {
        moving.ends[k].d = star(5, 1, true).ends[k].v - pentagram.ends[k].v + moving.centre.d;
    }
    EXPECT_FALSE(goes_round_once(moving));
    moving.t = 1;
    EXPECT_TRUE(goes_round_once(moving));
}

// The third edge runs along the first again, or beside it by the smallest number.
TEST(Winding, IsExactBesideTheFirstEdge) {
    Star spiral{{Vec3::Zero(), Vec3::UnitZ()}, {}, false};
    for (const Vec3& end : {Vec3(1, 0, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0), Vec3(3, 0, 0)}) {
        spiral.ends.push_back({end, Vec3::Zero()});
    }
    EXPECT_FALSE(goes_round_once(spiral));
    spiral.ends.back().v.y() = std::numeric_limits<double>::denorm_min();
    EXPECT_FALSE(goes_round_once(spiral));
    spiral.ends.back().v.y() = -std::numeric_limits<double>::denorm_min();
    EXPECT_TRUE(goes_round_once(spiral));
}

} // namespace
} // namespace foldless::verification
