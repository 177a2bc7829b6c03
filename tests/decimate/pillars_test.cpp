#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/pillars.h>

namespace foldless {
namespace {

using test::moved;
using test::pyramid;
using test::World;

TEST(OddEdges, ForgetsAnEdgeCrossedTwice) {
    OddEdges odd;
    EXPECT_TRUE(odd.empty());
    odd.toggle(3, 1);
    EXPECT_TRUE(odd.contains(1, 3));
    EXPECT_TRUE(odd.contains(3, 1));
    odd.toggle(1, 2);
    EXPECT_EQ(odd.size(), 2);
    odd.toggle(1, 3);
    EXPECT_FALSE(odd.contains(1, 3));
    EXPECT_TRUE(odd.contains(2, 1));
    odd.clear();
    EXPECT_TRUE(odd.empty());
}

// The base: a flat fan of four faces around 4, none of its vertices kept. Scan triangles hang above it.
//
//     3 ----- 2
//     | \   / |
//     |   4   |
//     | /   \ |
//     0 ----- 1
class FlatFan : public testing::Test {
protected:
    FlatFan() {
        patch_ = world_.replacing_all({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
        for (std::int32_t v = 0; v < 5; ++v) {
            patch_.changed.push_back(moved(v, world_.scan().positions[v]));
        }
    }

    Verdict flood(const ScanTriangle& triangle, const std::vector<std::array<std::int32_t, 2>>& edges) {
        surface_.reset(patch_, false);
        OddEdges odd;
        for (const auto& [a, b] : edges) {
            odd.toggle(a, b);
        }
        return PillarFlood().find(surface_, triangle, odd, inside_);
    }

    const std::vector<std::array<std::int32_t, 2>> spokes_{{4, 0}, {4, 1}, {4, 2}, {4, 3}};
    World world_{pyramid({0.5, 0.5, 0})};
    Patch patch_;
    PatchedSurface surface_{world_.base()};
    std::vector<std::int32_t> inside_;
};

const ScanTriangle around_the_middle{Vec3(0.3, 0.3, 0.25), Vec3(0.75, 0.4, 0.25), Vec3(0.45, 0.75, 0.25)};

TEST_F(FlatFan, FindsTheVertexInsideAScanTriangle) {
    ASSERT_EQ(flood(around_the_middle, spokes_), Verdict::accepted);
    EXPECT_EQ(inside_, std::vector<std::int32_t>{4});
}

TEST_F(FlatFan, FindsNothingWithoutOddEdges) {
    EXPECT_EQ(flood(around_the_middle, {}), Verdict::accepted);
    EXPECT_TRUE(inside_.empty());
}

TEST_F(FlatFan, RefusesParitiesThatDoNotFit) {
    EXPECT_EQ(flood(around_the_middle, {spokes_[0], spokes_[1], spokes_[2]}), Verdict::normal_condition);
    EXPECT_EQ(flood(around_the_middle, {spokes_[0]}), Verdict::normal_condition);
    EXPECT_EQ(flood(around_the_middle, {{0, 1}}), Verdict::normal_condition); // neither end is inside
    std::vector<std::array<std::int32_t, 2>> one_more = spokes_;
    one_more.push_back({0, 1});
    EXPECT_EQ(flood(around_the_middle, one_more), Verdict::normal_condition);
}

TEST_F(FlatFan, RefusesAVertexThatItsPillarMisses) {
    ScanTriangle beside = around_the_middle;
    for (Vec3& q : beside) {
        q.x() += 0.5;
    }
    EXPECT_EQ(flood(beside, spokes_), Verdict::normal_condition);
}

TEST_F(FlatFan, RefusesATriangleSeenFromBehind) {
    const auto& q = around_the_middle;
    EXPECT_EQ(flood({q[0], q[2], q[1]}, spokes_), Verdict::normal_condition);
}

TEST_F(FlatFan, RefusesAPillarThroughAnEdgeAsATie) {
    const ScanTriangle through{Vec3(0.25, 0.5, 0.25), Vec3(0.75, 0.5, 0.25), Vec3(0.5, 0.75, 0.25)};
    EXPECT_EQ(flood(through, spokes_), Verdict::tie);
    ScanTriangle beside = through;
    beside[0].y() -= 0x1p-20;
    EXPECT_EQ(flood(beside, spokes_), Verdict::accepted);
}

TEST_F(FlatFan, TakesNoKeptVertexForOneInside) {
    patch_.changed[4].value.scan_vertex = 4;
    EXPECT_EQ(flood(around_the_middle, spokes_), Verdict::normal_condition);
}

// A scan triangle over 4 and its neighbour 1 of a larger fan: the flood goes on from one to the other.
TEST(PillarFlood, FloodsThroughEdgesThatAreNotOdd) {
    World world(test::terrain(4, 0.0)); // 5 * 5 vertices, a quarter apart, cut from lower left to upper right
    Patch patch;
    patch.removed = world.all_faces();
    for (const std::int32_t f : patch.removed) {
        patch.added.push_back({world.base().corners(f), -1});
    }
    for (std::int32_t v = 0; v < 25; ++v) {
        patch.changed.push_back(moved(v, world.scan().positions[v]));
    }
    PatchedSurface surface(world.base());
    surface.reset(patch, false);
    // Around vertices 11 and 12, at (0.25, 0.5) and (0.5, 0.5).
    const ScanTriangle triangle{Vec3(0.1875, 0.45, 0.25), Vec3(0.6875, 0.45, 0.25), Vec3(0.3125, 0.6875, 0.25)};
    OddEdges odd;
    for (const std::int32_t v : {11, 12}) {
        for (const std::int32_t spoke : surface.fan(v).spokes) {
            odd.toggle(v, spoke); // the edge between the two is met twice, hence even
        }
    }
    ASSERT_EQ(odd.size(), 10);
    std::vector<std::int32_t> inside;
    EXPECT_EQ(PillarFlood().find(surface, triangle, odd, inside), Verdict::accepted);
    ASSERT_EQ(inside.size(), 2);
    EXPECT_EQ(inside[0] + inside[1], 23);
    odd.toggle(11, 12);
    EXPECT_EQ(PillarFlood().find(surface, triangle, odd, inside), Verdict::normal_condition);
}

} // namespace
} // namespace foldless
