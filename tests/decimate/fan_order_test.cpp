#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/fan_order.h>

#include <memory>

namespace foldless {
namespace {

using test::bipyramid;
using test::moved;
using test::pyramid;
using test::spindle;
using test::World;

/// The fan of a kept vertex with a patch in place.
struct Sorted {
    std::unique_ptr<PatchedSurface> surface; ///< holds the fan
    Verdict verdict;
    FanOrder order;
};

Sorted sort(World& world, const Patch& patch, std::int32_t v) {
    Sorted sorted{std::make_unique<PatchedSurface>(world.base()), {}, {}};
    sorted.surface->reset(patch, false);
    sorted.verdict = sorted.order.reset(v, *sorted.surface, world.scan(), world.topology());
    return sorted;
}

Sorted sort_flattened(const Vec3& top, std::int32_t v) {
    World world(pyramid(top));
    Patch patch = world.replacing_all({{0, 1, 2}, {0, 2, 3}});
    patch.changed.push_back(moved(4, top));
    return sort(world, patch, v);
}

TEST(FanOrder, CountsHalfStepsFromBaseEdgeToBaseEdge) {
    const auto [surface, verdict, order] = sort_flattened({0.4, 0.7, 0.3}, 0);
    ASSERT_EQ(verdict, Verdict::accepted);
    EXPECT_EQ(order.vertex(), 0);
    EXPECT_EQ(order.position(1), 0);
    EXPECT_EQ(order.position(4), 3); // within the second face, to the left of the diagonal
    EXPECT_EQ(order.position(3), 4);
    EXPECT_TRUE(order.is_base_edge(3));
    EXPECT_FALSE(order.is_base_edge(4));
    EXPECT_EQ(order.start_cell(4), 1);
    EXPECT_EQ(order.steps(0, 3), 3);
    EXPECT_EQ(order.steps(3, 0), -3); // the fan of a border vertex is open
}

TEST(FanOrder, PutsTheEdgeOnTheOtherSideOfTheDiagonal) {
    const auto [surface, verdict, order] = sort_flattened({0.7, 0.4, 0.3}, 0);
    ASSERT_EQ(verdict, Verdict::accepted);
    EXPECT_EQ(order.position(4), 1);
    EXPECT_EQ(order.start_cell(4), 0);
}

TEST(FanOrder, PutsAnEdgeOnABaseEdgeThatItIsNotIntoTheLowerFace) {
    const auto [surface, verdict, order] = sort_flattened({0.5, 0.5, 0.3}, 0);
    ASSERT_EQ(verdict, Verdict::accepted);
    EXPECT_EQ(order.start_cell(4), 0);
    const auto beside = sort_flattened({0.5, 0.5 + 0x1p-52, 0.3}, 0);
    ASSERT_EQ(beside.verdict, Verdict::accepted);
    EXPECT_EQ(beside.order.start_cell(4), 1);
}

TEST(FanOrder, RefusesAnEdgeOutsideTheFan) {
    EXPECT_EQ(sort_flattened({0.4, -0.1, 0.3}, 0).verdict, Verdict::no_preimage);
    EXPECT_EQ(sort_flattened({-0.1, 0.4, 0.3}, 0).verdict, Verdict::no_preimage);
    EXPECT_EQ(sort_flattened({0.1, 0.4, 0.3}, 0).verdict, Verdict::accepted);
}

// The top lies over a face that represents itself.
TEST(FanOrder, RefusesAnEdgeIntoAFaceThatRepresentsItself) {
    for (const auto& [x, verdict] : {std::pair{0.25, Verdict::no_preimage}, std::pair{0.75, Verdict::accepted}}) {
        Scan scan = pyramid({0.75, 0.25, 0.3}); // faces (0, 1, 4), (1, 2, 4), (2, 0, 4), (0, 2, 3)
        scan.faces = {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {0, 2, 3}};
        scan.positions[4] = {x, 1 - x, 0.3};
        World world(scan);
        Patch patch;
        patch.removed = {0, 1, 2};
        patch.added = {{{0, 1, 2}, -1}};
        patch.changed = {moved(4, scan.positions[4])};
        EXPECT_EQ(sort(world, patch, 0).verdict, verdict) << x;
    }
}

TEST(FanOrder, AcceptsAStarThatGoesRoundOnce) {
    World world(spindle(5, 1));
    for (const std::int32_t pole : {0, 1}) {
        const auto [surface, verdict, order] = sort(world, bipyramid(world, 4), pole);
        EXPECT_EQ(verdict, Verdict::accepted);
        EXPECT_TRUE(order.fan().closed);
        EXPECT_EQ(order.steps(order.position(3), order.position(2)) + order.steps(order.position(2), order.position(3)),
                  8);
    }
}

TEST(FanOrder, RefusesAStarThatGoesRoundTwice) {
    World world(spindle(7, 2));
    for (const std::int32_t pole : {0, 1}) {
        EXPECT_EQ(sort(world, bipyramid(world, 4), pole).verdict, Verdict::orientation);
    }
}

} // namespace
} // namespace foldless
