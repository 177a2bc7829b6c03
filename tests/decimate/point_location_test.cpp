#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/point_location.h>

#include <utility>
#include <vector>

namespace foldless {
namespace {

using test::moved;
using test::pyramid;
using test::World;

// The unit square of two faces, its directions up; none of its corners is kept.
//
//     3 ----- 2
//     |  1 /  |
//     |  /  0 |
//     0 ----- 1
class OnASquare : public testing::Test {
protected:
    OnASquare() {
        patch_ = world_.replacing_all({{0, 1, 2}, {0, 2, 3}});
        for (std::int32_t v = 0; v < 5; ++v) {
            patch_.changed.push_back(moved(v, world_.scan().positions[v]));
        }
    }

    Verdict locate(const Vec3& q, Uniqueness uniqueness = Uniqueness::in_range) {
        surface_.reset(patch_, false);
        const Verdict ready = location_.reset(surface_, uniqueness);
        if (ready != Verdict::accepted) {
            return ready;
        }
        location_.solve({&q, 1});
        return location_.locate(0, lift_);
    }

    World world_{pyramid({0.5, 0.25, 0})};
    Patch patch_;
    PatchedSurface surface_{world_.base()};
    PointLocation location_;
    Lift lift_{};
};

TEST_F(OnASquare, APointLiesInOneFace) {
    ASSERT_EQ(locate({0.75, 0.25, 0.5}), Verdict::accepted);
    EXPECT_EQ(lift_.cell, 0);
    EXPECT_EQ(lift_.walls, 0U);
    EXPECT_NEAR(lift_.at.t, 0.5, 1e-15);
    EXPECT_NEAR((lift_.at.alpha - Vec3(0.25, 0.5, 0.25)).norm(), 0, 1e-15);
    ASSERT_EQ(locate({0.25, 0.75, -0.5}), Verdict::accepted);
    EXPECT_EQ(lift_.cell, 1);
    EXPECT_TRUE(location_.alternatives().empty());
}

TEST_F(OnASquare, APointOnTheWallBetweenFacesBelongsToTheFirst) {
    for (const auto& corners : {Triangle{0, 1, 2}, Triangle{2, 3, 0}}) {
        ASSERT_EQ(locate({0.375, 0.375, 0.5}), Verdict::accepted);
        EXPECT_EQ(lift_.cell, 0);
        EXPECT_EQ(surface_.cell(0).corners, corners);
        EXPECT_EQ(lift_.walls, wall_bit(surface_.corner_of(0, corners[1])));
        EXPECT_TRUE(location_.alternatives().empty()); // the other face has the same place, no second one
        std::swap(patch_.added[0], patch_.added[1]);
        patch_.added[0].corners = {2, 3, 0};
    }
}

TEST_F(OnASquare, APlaceOnAWallIsHandedToTheLowerCell) {
    ASSERT_EQ(locate({0.25, 0.25, 0.5}), Verdict::accepted);
    const int on_wall = surface_.corner_of(1, 3);
    Lift upper{1, lift_.at, wall_bit(on_wall)};
    upper.at.alpha = Vec3(0.75, 0.25, 0); // 0, 2, 3
    Lift lower = in_lower_cell(surface_, upper);
    EXPECT_TRUE(same_point(surface_, lower, upper));
    EXPECT_EQ(lower.cell, 0);
    EXPECT_EQ(lower.walls, wall_bit(surface_.corner_of(0, 1)));
    EXPECT_EQ(lower.at.alpha, Vec3(0.75, 0, 0.25)); // 0, 1, 2
    EXPECT_EQ(lower.at.t, upper.at.t);
    // There is none below it; and what lies on no wall, or on the border, stays.
    EXPECT_EQ(in_lower_cell(surface_, lower).cell, 0);
    upper.walls = 0;
    EXPECT_EQ(in_lower_cell(surface_, upper).cell, 1);
    upper.walls = wall_bit(surface_.corner_of(1, 0));
    EXPECT_EQ(in_lower_cell(surface_, upper).cell, 1);
}

TEST_F(OnASquare, APointOnTheWallOfTheBorderIsATie) {
    EXPECT_EQ(locate({0.5, 0, 0.5}), Verdict::tie);
    EXPECT_EQ(locate({0.5, 0x1p-30, 0.5}), Verdict::accepted);
    EXPECT_EQ(locate({0.5, -0x1p-30, 0.5}), Verdict::no_preimage);
}

TEST_F(OnASquare, APointOnAPillarIsATie) {
    EXPECT_EQ(locate({1, 1, 0.5}), Verdict::tie);
}

TEST_F(OnASquare, APointBesideTheSquareHasNoPlace) {
    EXPECT_EQ(locate({1.5, 0.5, 0.5}), Verdict::no_preimage);
    EXPECT_EQ(locate({0.5, -3, -0.5}), Verdict::no_preimage);
}

TEST_F(OnASquare, AFaceThatFoldsAtOnceIsRefusedBeforeAnyPoint) {
    patch_.changed[1].value.direction = Vec3(0, 0, -1);
    EXPECT_EQ(locate({0.25, 0.75, 0.5}), Verdict::jacobian);
}

TEST_F(OnASquare, ManyPointsHaveTheVerdictsAndPlacesOfEach) {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < PointLocation::most_points; ++k) {
        const double x = static_cast<double>(k % 9) / 8; // on walls, pillars and the border, too, and beside it
        const double y = static_cast<double>(k / 9) / 12;
        points.emplace_back(x, y, 0.5 * x - 0.25);
    }
    for (const Uniqueness uniqueness : {Uniqueness::in_range, Uniqueness::fold_free}) {
        surface_.reset(patch_, false);
        PointLocation together;
        ASSERT_EQ(together.reset(surface_, uniqueness), Verdict::accepted);
        together.solve(points);
        for (std::size_t k = 0; k < points.size(); ++k) {
            Lift lift{};
            const Verdict verdict = together.locate(static_cast<int>(k), lift);
            ASSERT_EQ(verdict, locate(points[k], uniqueness)) << k;
            if (verdict == Verdict::accepted) {
                EXPECT_EQ(lift.cell, lift_.cell) << k;
                EXPECT_EQ(lift.walls, lift_.walls) << k;
                EXPECT_EQ(lift.at.t, lift_.at.t) << k;
                EXPECT_EQ(lift.at.alpha, lift_.at.alpha) << k;
            }
        }
    }
}

// Two faces opposite each other, at y = 0 and y = 1; q lies before both.
TEST_F(OnASquare, APointBeforeTwoFacesGoesToTheNearerOne) {
    patch_.added = {{{0, 1, 2}, -1}, {{3, 4, 5}, -1}};
    patch_.changed = {moved(0, {0, 0, 0}, {0, 1, 0}),  moved(1, {0, 0, 1}, {0, 1, 0}),
                      moved(2, {1, 0, 0}, {0, 1, 0}),  moved(3, {0, 1, 0}, {0, -1, 0}),
                      moved(4, {1, 1, 0}, {0, -1, 0}), moved(5, {0, 1, 1}, {0, -1, 0})};
    const Vec3 q(0.25, 0.375, 0.25);
    ASSERT_EQ(locate(q), Verdict::accepted);
    EXPECT_EQ(lift_.cell, 0);
    ASSERT_EQ(location_.alternatives().size(), 1);
    EXPECT_EQ(location_.alternatives()[0].cell, 1);
    EXPECT_GT(std::abs(location_.alternatives()[0].at.t), std::abs(lift_.at.t));
    EXPECT_EQ(locate(q, Uniqueness::fold_free), Verdict::several_preimages);
}

} // namespace
} // namespace foldless
