// The validator knows nothing of collapses: flips, splits, relocations and new directions are patches like any other.

#include "made_scans.h"
#include "validator_world.h"

#include <gmock/gmock.h>

namespace foldless {
namespace {

using test::moved;
using test::pyramid;
using test::World;
using testing::ElementsAre;

/// Two triangles over 0, 1, 2, 3 that share the edge 0-2; vertex 2 is the given one.
Scan two_triangles(const Vec3& second) {
    return {{{0, 0, 0}, {1, 0, 0}, second, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, false};
}

Patch flip(const World& world) {
    return world.replacing_all({{0, 1, 3}, {1, 2, 3}});
}

TEST(EdgeFlip, IsAcceptedOverABentQuadrilateral) {
    for (const double height : {0.5, -0.5, 0.0}) {
        World world(two_triangles({1, 1, height}));
        EXPECT_EQ(world.judge(flip(world)), Verdict::accepted) << height;
        EXPECT_TRUE(world.trial().places.empty()); // all scan vertices stay kept
        EXPECT_THAT(world.trial().faces[0].scan_faces, ElementsAre(0, 1));
        // The scan edge 0-2 passes over the middle of the base edge 1-3.
        const Range range = world.trial().faces[0].range;
        EXPECT_NEAR(height > 0 ? range.hi : range.lo, height / 2, 1e-7);
        EXPECT_TRUE(range.lo <= height / 2 && height / 2 <= range.hi);
    }
}

TEST(EdgeFlip, IsRefusedInAQuadrilateralThatIsNotConvex) {
    World dented(two_triangles({0.25, 0.25, 0}));
    EXPECT_EQ(dented.judge(flip(dented)), Verdict::jacobian);
    World convex(two_triangles({0.75, 0.75, 0}));
    EXPECT_EQ(convex.judge(flip(convex)), Verdict::accepted);
}

// 0, 2 and the middle of 1-3 on a line, 1-2-3 too: the new face 1, 2, 3 has no area.
TEST(EdgeFlip, IsRefusedWhereItLeavesNoArea) {
    World world(two_triangles({0.5, 0.5, 0}));
    EXPECT_NE(world.judge(flip(world)), Verdict::accepted);
}

TEST(EdgeFlip, BackMakesTheScanItselfAndIsAccepted) {
    World world(two_triangles({1, 1, 0.5}));
    Patch patch;
    patch.removed = {0, 1};
    patch.added = {{{1, 2, 0}, 0}, {{2, 3, 0}, 1}};
    EXPECT_EQ(world.judge(patch), Verdict::accepted);
    for (const Trial::NewFace& face : world.trial().faces) {
        EXPECT_TRUE(face.is_scan_face);
        EXPECT_EQ(face.range.lo, 0);
        EXPECT_EQ(face.range.hi, 0);
    }
}

/// The patch that moves the top of a pyramid on the base mesh.
Patch relocation(const Vec3& place, const Vec3& direction = Vec3::UnitZ()) {
    Patch patch;
    patch.removed = {0, 1, 2, 3};
    patch.added = {{{0, 1, 4}, 0}, {{1, 2, 4}, 1}, {{2, 3, 4}, 2}, {{3, 0, 4}, 3}};
    patch.changed.push_back(moved(4, place, direction));
    return patch;
}

Verdict relocated(const Vec3& top, const Patch& patch) {
    World world(pyramid(top));
    return world.judge(patch);
}

TEST(Relocation, IsAcceptedWhereThePillarStillMeetsTheScan) {
    World world(pyramid({0.4, 0.7, 0.3}));
    ASSERT_EQ(world.judge(relocation({0.5, 0.45, 0.0})), Verdict::accepted);
    ASSERT_EQ(world.trial().places.size(), 1);
    EXPECT_EQ(world.trial().places[0].scan_vertex, 4);
    // Beneath the new place lies the side (0, 1, 4), at height 0.3 * 0.45 / 0.7: all four faces must reach it.
    for (const Trial::NewFace& face : world.trial().faces) {
        EXPECT_TRUE(face.range.lo <= 0.3 * 0.45 / 0.7 && face.range.hi >= 0.3 * 0.45 / 0.7);
        EXPECT_FALSE(face.is_scan_face);
    }
}

TEST(Relocation, IsRefusedOutsideTheRim) {
    EXPECT_EQ(relocated({0.4, 0.7, 0.3}, relocation({1.125, 0.5, 0})), Verdict::jacobian);
    EXPECT_EQ(relocated({0.4, 0.7, 0.3}, relocation({0.875, 0.5, 0})), Verdict::accepted);
}

TEST(Relocation, IsRefusedWithADirectionThatLeavesTheSquare) {
    // From (0.5, 0.45) the ray is beyond the edge 1-2 at the height of the scan, for all that J > 0 where it starts.
    EXPECT_NE(relocated({0.9, 0.5, 0.3}, relocation({0.5, 0.45, -0.5}, {1, 0, 1})), Verdict::accepted);
    EXPECT_EQ(relocated({0.9, 0.5, 0.3}, relocation({0.5, 0.45, -0.25}, {0, 0, 1})), Verdict::accepted);
}

// The scan vertex on the pillar of a base vertex that is not kept lies in four faces at once, a tie.
TEST(Relocation, IsRefusedAlongThePillarOfTheVertex) {
    EXPECT_EQ(relocated({0.5, 0.5, 0.25}, relocation({0.5, 0.5, 0})), Verdict::tie);
    EXPECT_EQ(relocated({0.5, 0.5, 0.25}, relocation({0.5, 0.5 + 0x1p-10, 0})), Verdict::accepted);
}

TEST(Relocation, ToTheSamePlaceAsAScanVertexKeepsEverything) {
    World world(pyramid({0.4, 0.7, 0.3}));
    Patch patch = relocation({0.4, 0.7, 0.3});
    patch.changed[0].value.scan_vertex = 4;
    ASSERT_EQ(world.judge(patch), Verdict::accepted);
    EXPECT_TRUE(world.trial().places.empty());
    EXPECT_TRUE(world.trial().faces[2].is_scan_face);
}

/// One scan face 0, 1, 2 and the patch that splits it at a new vertex 3.
Verdict split_at(const Vec3& place, const Vec3& direction, Trial* trial = nullptr) {
    World world(Scan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, true});
    Patch patch = world.replacing_all({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    patch.changed.push_back(moved(3, place, direction));
    const Verdict verdict = world.judge(patch);
    if (trial != nullptr) {
        *trial = world.trial();
    }
    return verdict;
}

TEST(Split, IsAcceptedBelowTheScanFace) {
    Trial trial;
    ASSERT_EQ(split_at({0.3, 0.4, -0.25}, {0, 0, 1}, &trial), Verdict::accepted);
    for (const Trial::NewFace& face : trial.faces) {
        EXPECT_THAT(face.scan_faces, ElementsAre(0));
        EXPECT_GE(face.range.hi, 0.25); // where the pillar of the new vertex meets the scan face
        EXPECT_NEAR(face.range.hi, 0.25, 1e-7);
        EXPECT_LE(face.range.lo, 0);
    }
}

TEST(Split, IsRefusedWhereThePillarMissesTheScanFace) {
    EXPECT_EQ(split_at({0.6, 0.6, -0.25}, {0, 0, 1}), Verdict::jacobian);
    EXPECT_EQ(split_at({0.45, 0.45, -0.25}, {0, 0, 1}), Verdict::accepted);
    // Tilted, the pillar of that vertex passes beside the face.
    EXPECT_NE(split_at({0.45, 0.45, -0.25}, {0.3, 0.3, 1}), Verdict::accepted);
    EXPECT_EQ(split_at({0.45, 0.45, -0.25}, {0.05, 0.05, 1}), Verdict::accepted);
}

TEST(Split, IsRefusedWithADirectionThatSeesTheScanFaceFromBehind) {
    EXPECT_EQ(split_at({0.3, 0.4, -0.25}, {0, 0, -1}), Verdict::jacobian);
}

// Splitting the edge 0-2 of two flat triangles at a point of it: the new vertex, if it is kept as no scan vertex, lies
// on a scan edge, which is a tie; beside the edge it is not.
TEST(Split, OfAnEdgeIsATieOnTheScanEdge) {
    const std::vector<Triangle> fan{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    for (const auto& [x, accepted] : {std::pair{0.5, false}, std::pair{0.5625, true}}) {
        World world(two_triangles({1, 1, 0.25}));
        Patch patch = world.replacing_all(fan);
        patch.changed.push_back(moved(4, {x, 0.5, 0}));
        EXPECT_EQ(world.judge(patch) == Verdict::accepted, accepted) << x;
    }
}

TEST(NewDirections, AreJudgedLikeAnyOtherPatch) {
    for (const auto& [tilt, accepted] : {std::pair{0.25, true}, std::pair{-8.0, false}}) {
        World world(pyramid({0.4, 0.7, 0.3}));
        Patch flatten = world.collapse_patch(4, 0);
        ASSERT_EQ(world.judge(flatten), Verdict::accepted);
        world.commit_collapse(4, 0, flatten);
        Patch patch;
        for (const std::int32_t f : {1, 2}) {
            patch.removed.push_back(f);
            patch.added.push_back({world.base().corners(f), f});
        }
        patch.changed.push_back({2, {world.scan().positions[2], Vec3(tilt, 0, 1), 2}});
        EXPECT_EQ(world.judge(patch) == Verdict::accepted, accepted) << tilt;
    }
}

TEST(Validator, TouchesNothing) {
    World world(pyramid({0.4, 0.7, 0.3}));
    const Patch patch = world.collapse_patch(4, 0);
    ASSERT_EQ(world.judge(patch), Verdict::accepted);
    ASSERT_EQ(world.judge(patch), Verdict::accepted); // the same answer again
    for (std::int32_t f = 0; f < 4; ++f) {
        EXPECT_EQ(world.base().corners(f)[0] + world.base().corners(f)[1] + world.base().corners(f)[2],
                  world.scan().faces[f][0] + world.scan().faces[f][1] + world.scan().faces[f][2]);
        EXPECT_TRUE(world.base().face(f).is_scan_face);
        EXPECT_THAT(world.base().face(f).scan_faces, ElementsAre(f));
    }
    EXPECT_EQ(world.base().place(4).kept, 4);
}

TEST(Validator, GathersEveryScanFaceOnce) {
    World world(pyramid({0.4, 0.7, 0.3}));
    const std::vector<std::int32_t> first{0, 1, 2};
    const std::vector<std::int32_t> second{1, 3};
    world.base().set_face(0, {{0.0, 0.0}, first, -1, false});
    world.base().set_face(1, {{0.0, 0.0}, second, -1, false});
    Validator validator(world.base(), world.prepared(), {});
    EXPECT_THAT(validator.gather({0, 1}), testing::UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_THAT(validator.gather({1}), testing::UnorderedElementsAre(1, 3));
}

} // namespace
} // namespace foldless
