#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/edge_trace.h>

namespace foldless {
namespace {

using test::moved;
using test::World;

// Two unit squares beside each other, each of two faces; walls of interest: 1-4 in the middle, and the diagonals.
//
//     5 ------ 4 ------ 3
//     |      / |      / |
//     |  1 /   |  3 /   |      faces by index
//     |  / 0   |  / 2   |
//     0 ------ 1 ------ 2
class TwoSquares : public testing::Test {
protected:
    TwoSquares() {
        patch_ = world_.replacing_all({{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}});
        for (std::int32_t v = 0; v < 6; ++v) { // moving faces, not the scan's
            patch_.changed.push_back(moved(v, world_.scan().positions[v]));
        }
    }

    void SetUp() override {
        surface_.reset(patch_, false);
        for (int c = 0; c < 4; ++c) {
            surface_.cell(c).range = {-1, 1};
        }
    }

    /// The place of a point in a cell; at its own height if it is elsewhere.
    PrismoidPoint place(const Vec3& q, int cell) {
        const auto found = PointFinder(surface_.cell(cell).triangle, {-1, 1}).find(q);
        return found ? *found : PrismoidPoint{Displacement(q.z()), 0};
    }

    Verdict trace(const Vec3& a, int cell_a, const Vec3& b, int cell_b) {
        crossings_.clear();
        a_ = a;
        b_ = b;
        return trace_edge(surface_, {&a_, cell_a, place(a_, cell_a)}, {&b_, cell_b, place(b_, cell_b)}, crossings_);
    }

    [[nodiscard]] double t(std::size_t crossing) const { return crossings_[crossing].t.approximate(); }

    World world_{Scan{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}},
                      {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}}}};
    Patch patch_;
    PatchedSurface surface_{world_.base()};
    std::vector<TraceCrossing> crossings_;
    Vec3 a_, b_; ///< the crossings refer to them
};

TEST_F(TwoSquares, AnEdgeWithinOneCellCrossesNothing) {
    EXPECT_EQ(trace({0.25, 0.125, 0.1}, 0, {0.875, 0.5, 0.4}, 0), Verdict::accepted);
    EXPECT_TRUE(crossings_.empty());
}

TEST_F(TwoSquares, AnEdgeGoesStraightThroughTwoWalls) {
    // From above the left diagonal to below the right one: across the left diagonal, the middle and the right diagonal.
    ASSERT_EQ(trace({0.25, 0.75, 0.0}, 1, {1.75, 0.25, 0.6}, 2), Verdict::accepted);
    ASSERT_EQ(crossings_.size(), 3);
    EXPECT_EQ(crossings_[0].from, 1);
    EXPECT_EQ(crossings_[0].to, 0);
    EXPECT_EQ(crossings_[1].from, 0);
    EXPECT_EQ(crossings_[1].to, 3);
    EXPECT_EQ(crossings_[2].from, 3);
    EXPECT_EQ(crossings_[2].to, 2);
    EXPECT_NEAR(t(1), 0.3, 1e-14);
    // y = 0.75 - (x - 0.25) / 3 meets y = x at 0.625 and y = x - 1 at 1.375.
    EXPECT_NEAR(t(0), 0.6 * 0.375 / 1.5, 1e-14);
    EXPECT_NEAR(t(2), 0.6 * 1.125 / 1.5, 1e-14);
    for (const TraceCrossing& crossing : crossings_) {
        EXPECT_LT(crossing.t.bounds().hi - crossing.t.bounds().lo, 1e-12);
    }
}

TEST_F(TwoSquares, TheWayBackCrossesTheSameWalls) {
    ASSERT_EQ(trace({1.75, 0.25, 0.6}, 2, {0.25, 0.75, 0.0}, 1), Verdict::accepted);
    ASSERT_EQ(crossings_.size(), 3);
    EXPECT_EQ(crossings_[0].from, 2);
    EXPECT_EQ(crossings_[2].to, 1);
}

// Without the face (1, 3, 4) the straight way from the left square to the right one leads over the border.
TEST_F(TwoSquares, AnEdgeCannotLeaveThroughTheBorder) {
    ASSERT_EQ(trace({0.75, 0.375, 0.1}, 0, {1.5, 0.25, 0.1}, 2), Verdict::accepted);
    patch_.added.pop_back();
    surface_.reset(patch_, false);
    for (int c = 0; c < 3; ++c) {
        surface_.cell(c).range = {-1, 1};
    }
    EXPECT_EQ(trace({0.75, 0.375, 0.1}, 0, {1.5, 0.25, 0.1}, 2), Verdict::no_preimage);
}

TEST_F(TwoSquares, AnEdgeCannotEnterAFaceThatRepresentsItself) {
    surface_.cell(3).impassable = true;
    EXPECT_EQ(trace({0.75, 0.5, 0.1}, 0, {1.25, 0.5, 0.1}, 3), Verdict::no_preimage);
    surface_.cell(3).impassable = false;
    EXPECT_EQ(trace({0.75, 0.5, 0.1}, 0, {1.25, 0.5, 0.1}, 3), Verdict::accepted);
}

TEST_F(TwoSquares, AnEdgeThatEndsInAnotherCellThanItLeadsToIsRefused) {
    EXPECT_NE(trace({0.75, 0.5, 0.1}, 0, {1.25, 0.5, 0.1}, 2), Verdict::accepted);
    EXPECT_NE(trace({0.75, 0.5, 0.1}, 0, {0.875, 0.5, 0.1}, 3), Verdict::accepted);
}

TEST_F(TwoSquares, AnEdgeThroughAPillarIsATie) {
    // Through the middle of 1-4 both ways is fine; through 4 or 1 itself it is a tie.
    EXPECT_NE(trace({0.5, 0.75, 0.1}, 1, {1.5, 1.25, 0.1}, 3), Verdict::accepted);
    EXPECT_EQ(trace({0.75, 0.25, 0.1}, 0, {1.25, -0.25, 0.1}, 2), Verdict::tie);
}

// The walls of tilted directions: the edge stays straight above the squares, the wall in the middle leans over it.
TEST_F(TwoSquares, AnEdgeCrossesALeaningWallWhereItIs) {
    for (const std::size_t v : {1U, 4U}) {
        patch_.changed[v].value.direction = {0.5, 0, 1};
    }
    surface_.reset(patch_, false);
    for (int c = 0; c < 4; ++c) {
        surface_.cell(c).range = {-1, 1};
    }
    // At t = 0.5 the wall stands at x = 1.25.
    ASSERT_EQ(trace({0.875, 0.5, 0.5}, 0, {1.375, 0.5, 0.5}, 3), Verdict::accepted);
    ASSERT_EQ(crossings_.size(), 1);
    EXPECT_NEAR(t(0), 0.5, 1e-14);
    ASSERT_EQ(trace({0.875, 0.5, 0.5}, 0, {1.125, 0.5, 0.5}, 0), Verdict::accepted);
    EXPECT_TRUE(crossings_.empty());
}

// The wall of the diagonal turns over the edge that leaves its end 0 beside it: seen from above they start along slopes
// of 1 and 0.9, and meet where the wall has the slope (1 - t/4) / (1 + t/4) = 0.9.
TEST_F(TwoSquares, AnEdgeFromAKeptVertexMayLeaveThroughAWallThatEndsThere) {
    patch_.changed[4].value.direction = {0.25, -0.25, 1};
    surface_.reset(patch_, false);
    for (int c = 0; c < 4; ++c) {
        surface_.cell(c).range = {-1, 1};
    }
    a_ = Vec3::Zero();
    b_ = {0.6, 0.54, 0.6};
    const TraceEnd start{&a_, 0, {Displacement(), walls_at_corner(surface_.corner_of(0, 0))}};
    ASSERT_EQ(trace_edge(surface_, start, {&b_, 1, place(b_, 1)}, crossings_), Verdict::accepted);
    ASSERT_EQ(crossings_.size(), 1);
    EXPECT_NEAR(t(0), 4 * 0.1 / 1.9, 1e-14);
}

// The same wall, crossed upwards at x = 1/2 along y = 0.51 - z/4: the edge is beyond it in the middle only.
TEST_F(TwoSquares, AnEdgeMayCrossACurvedWallTwice) {
    patch_.changed[4].value.direction = {0.25, -0.25, 1};
    surface_.reset(patch_, false);
    for (int c = 0; c < 4; ++c) {
        surface_.cell(c).range = {-1, 1};
    }
    ASSERT_EQ(trace({0.5, 0.71, -0.8}, 0, {0.5, 0.31, 0.8}, 0), Verdict::accepted);
    ASSERT_EQ(crossings_.size(), 2);
    EXPECT_EQ(crossings_[0].to, 1);
    EXPECT_EQ(crossings_[1].to, 0);
    EXPECT_LT(t(0), 0);
    EXPECT_GT(t(1), 0);
    // A little lower it never reaches the wall.
    ASSERT_EQ(trace({0.5, 0.69, -0.8}, 0, {0.5, 0.29, 0.8}, 0), Verdict::accepted);
    EXPECT_TRUE(crossings_.empty());
}

} // namespace
} // namespace foldless
