#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/patched_surface.h>

#include <gmock/gmock.h>

namespace foldless {
namespace {

using test::moved;
using test::pyramid;
using test::World;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// A flat grid of 3 * 3 cells whose middle vertex 5 (of 16) goes into 6; the rim is the star of both.
class PatchInTheMiddle : public testing::Test {
protected:
    World world_{test::terrain(3, 0.0)};
    Patch patch_ = world_.collapse_patch(5, 6);
    PatchedSurface surface_{world_.base()};
    void SetUp() override { surface_.reset(patch_, false); }
};

TEST_F(PatchInTheMiddle, ListsTheNewFacesFirst) {
    ASSERT_EQ(surface_.new_cells(), static_cast<int>(patch_.added.size()));
    for (int c = 0; c < surface_.new_cells(); ++c) {
        EXPECT_EQ(surface_.cell(c).corners, patch_.added[c].corners);
        EXPECT_EQ(surface_.cell(c).face, -1);
    }
}

TEST_F(PatchInTheMiddle, SharesEveryEdgeWithTheNeighbourAcross) {
    int outside = 0;
    for (int c = 0; c < surface_.new_cells(); ++c) {
        for (int k = 0; k < 3; ++k) {
            const int other = surface_.neighbour(c, k);
            if (other == border) {
                continue;
            }
            outside += other >= surface_.new_cells() ? 1 : 0;
            const std::int32_t from = surface_.cell(c).corners[(k + 1) % 3];
            const int back = (surface_.corner_of(other, from) + 1) % 3;
            EXPECT_EQ(surface_.neighbour(other, back), c);
            EXPECT_EQ(surface_.cell(other).corners[(back + 1) % 3], surface_.cell(c).corners[(k + 2) % 3]);
        }
    }
    EXPECT_GT(outside, 0);
}

TEST_F(PatchInTheMiddle, GoesAroundVerticesAcrossTheRim) {
    for (std::int32_t v = 0; v < 16; ++v) {
        if (v == 5) {
            continue;
        }
        const Fan& fan = surface_.fan(v);
        EXPECT_EQ(fan.closed, !world_.base().is_border_vertex(v)) << v;
        EXPECT_EQ(fan.spokes.size(), fan.cells.size() + (fan.closed ? 0 : 1)) << v;
        for (std::size_t n = 0; n < fan.cells.size(); ++n) {
            const Cell& cell = surface_.cell(fan.cells[n]);
            const int k = surface_.corner_of(fan.cells[n], v);
            ASSERT_GE(k, 0);
            EXPECT_EQ(cell.corners[(k + 1) % 3], fan.spokes[n]);
            EXPECT_EQ(cell.corners[(k + 2) % 3], fan.spokes[(n + 1) % fan.spokes.size()]);
        }
        for (const std::int32_t spoke : fan.spokes) {
            EXPECT_NE(spoke, 5);
        }
    }
}

TEST_F(PatchInTheMiddle, FindsOutsideFacesOnce) {
    const std::int32_t last = static_cast<std::int32_t>(world_.scan().faces.size()) - 1;
    ASSERT_FALSE(surface_.removes(last));
    const int cell = surface_.cell_of(last);
    EXPECT_GE(cell, surface_.new_cells());
    EXPECT_EQ(surface_.cell_of(last), cell);
    EXPECT_EQ(surface_.cell(cell).face, last);
    EXPECT_TRUE(surface_.cell(cell).impassable);
}

TEST(PatchedSurface, TakesChangedVerticesFromThePatch) {
    World world(pyramid({0.4, 0.7, 0.3}));
    Patch patch = world.replacing_all({{0, 1, 2}, {0, 2, 3}});
    patch.changed.push_back(moved(2, {2, 2, 0}, {0, 1, 1}));
    PatchedSurface surface(world.base());
    surface.reset(patch, false);
    EXPECT_EQ(surface.vertex(2).position, Vec3(2, 2, 0));
    EXPECT_EQ(surface.cell(0).triangle.v[2], Vec3(2, 2, 0));
    EXPECT_EQ(surface.cell(1).triangle.d[1], Vec3(0, 1, 1));
    EXPECT_THAT(surface.cell(0).kept, ElementsAre(true, true, false));
    EXPECT_EQ(surface.vertex(3).position, world.scan().positions[3]);
}

TEST(PatchedSurface, GivesEachFaceItsOwnNormalWithConstantDirections) {
    World world(pyramid({0.4, 0.7, 0.3}));
    Patch patch = world.replacing_all({{0, 1, 2}, {0, 2, 3}});
    patch.changed.push_back(moved(2, {1, 1, 1}));
    PatchedSurface surface(world.base());
    surface.reset(patch, true);
    const Vec3 normal = Vec3(0, -1, 1).normalized();
    for (const Vec3& d : surface.cell(0).triangle.d) {
        EXPECT_NEAR((d - normal).norm(), 0, 1e-7);
        EXPECT_EQ(d, face_direction(surface.cell(0).triangle.v));
    }
}

// Overflowing products once made directions that are no numbers, in base meshes that verify() then refused.
TEST(FaceDirection, IsTheSameAtEveryMagnitude) {
    const std::array<Vec3, 3> corners{Vec3(0.25, 0, 1), Vec3(1, 0.125, -0.5), Vec3(-0.75, 1, 0.25)};
    const Vec3 expected = face_direction(corners);
    EXPECT_NEAR(expected.norm(), 1, 1e-7);
    for (const double unit : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1023}) {
        EXPECT_EQ(face_direction({unit * corners[0], unit * corners[1], unit * corners[2]}), expected) << unit;
    }
}

TEST(PatchedSurface, KnowsWhichNewFacesAreStillTheirScanFaces) {
    World world(pyramid({0.4, 0.7, 0.3}));
    Patch patch;
    patch.removed = {0, 1, 2, 3};
    patch.added = {{{1, 4, 0}, 0}, {{1, 2, 4}, -1}, {{2, 3, 4}, 2}, {{3, 0, 4}, 3}};
    PatchedSurface surface(world.base());
    surface.reset(patch, false);
    EXPECT_TRUE(surface.cell(0).impassable);  // turned corners, the same face
    EXPECT_FALSE(surface.cell(1).impassable); // takes over no face
    patch.changed.push_back(moved(3, world.scan().positions[3]));
    surface.reset(patch, false);
    EXPECT_TRUE(surface.cell(0).impassable);
    EXPECT_FALSE(surface.cell(2).impassable); // one of its corners is no longer kept
}

TEST(PatchedSurface, CanBeUsedForOnePatchAfterTheOther) {
    World world(test::terrain(3, 0.0));
    PatchedSurface surface(world.base());
    const Patch first = world.collapse_patch(5, 6);
    const Patch second = world.collapse_patch(10, 9);
    surface.reset(first, false);
    ASSERT_TRUE(surface.removes(first.removed.front()));
    static_cast<void>(surface.neighbour(0, 0));
    surface.reset(second, false);
    for (const std::int32_t f : first.removed) {
        EXPECT_EQ(surface.removes(f), std::count(second.removed.begin(), second.removed.end(), f) > 0);
    }
}

} // namespace
} // namespace foldless
