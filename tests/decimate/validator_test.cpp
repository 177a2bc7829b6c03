// Each verdict of the validator: a mesh that causes it, and a near miss that is accepted. The patch is in most cases
// the removal of the top of a pyramid, which leaves the square below:
//
//     3 ----- 2        3 ----- 2
//     | \   / |        |     / |
//     |   4   |   ->   |   /   |
//     | /   \ |        | /     |
//     0 ----- 1        0 ----- 1

#include "made_scans.h"
#include "validator_world.h"

#include <foldless/io/float32.h>

#include <gmock/gmock.h>

#include <cmath>

namespace foldless {
namespace {

using test::bipyramid;
using test::moved;
using test::pyramid;
using test::spindle;
using test::World;
using testing::ElementsAre;

const std::vector<Triangle> square{{0, 1, 2}, {0, 2, 3}};

/// The patch that flattens the pyramid.
Patch flattened(const World& world) {
    Patch patch = world.replacing_all(square);
    patch.changed.push_back(moved(4, world.scan().positions[4]));
    return patch;
}

Verdict judge_top(const Vec3& top, const ValidatorOptions& options = {}) {
    World world(pyramid(top));
    return world.judge(flattened(world), options);
}

ValidatorOptions at_most(double displacement) {
    ValidatorOptions options;
    options.max_displacement = displacement;
    return options;
}

ValidatorOptions constant_directions() {
    ValidatorOptions options;
    options.constant_directions = true;
    return options;
}

TEST(Validator, AcceptsAPyramidOverItsSquare) {
    World world(pyramid({0.4, 0.7, 0.3}));
    EXPECT_EQ(world.judge(flattened(world)), Verdict::accepted);
    const Trial& trial = world.trial();
    ASSERT_EQ(trial.places.size(), 1);
    EXPECT_EQ(trial.places[0].scan_vertex, 4);
    EXPECT_EQ(trial.places[0].face, 1);
    EXPECT_NEAR(trial.places[0].t, 0.3, 1e-15);
    EXPECT_NEAR((trial.places[0].alpha - Vec3(0.3, 0.4, 0.3)).norm(), 0, 1e-15);
    EXPECT_EQ(trial.retested, 1);
    // Every side but (0, 1, 4) and (1, 2, 4) lies over the face with 4; those two lie over both.
    EXPECT_THAT(trial.faces[0].scan_faces, ElementsAre(0, 1));
    EXPECT_THAT(trial.faces[1].scan_faces, ElementsAre(0, 1, 2, 3));
    EXPECT_FALSE(trial.faces[1].is_scan_face);
}

TEST(Validator, PutsEveryDisplacementIntoTheRange) {
    World world(pyramid({0.4, 0.7, 0.3}));
    ASSERT_EQ(world.judge(flattened(world)), Verdict::accepted);
    // The highest point over the face without the top is where the edge 1-4 crosses the diagonal: x = y = 0.7 / 1.3.
    const Range without = world.trial().faces[0].range;
    EXPECT_NEAR(without.hi, 0.3 * (1 - 0.7 / 1.3) / 0.6, 1e-7);
    EXPECT_GE(without.hi, 0.3 * (1 - 0.7 / 1.3) / 0.6);
    EXPECT_LE(without.lo, 0);
    const Range with = world.trial().faces[1].range;
    EXPECT_GE(with.hi, 0.3);
    EXPECT_NEAR(with.hi, 0.3, 1e-7);
    EXPECT_EQ(static_cast<double>(static_cast<float>(with.hi)), with.hi);
}

TEST(Validator, AcceptsADisplacementInwards) {
    World world(pyramid({0.4, 0.7, -0.3}));
    EXPECT_EQ(world.judge(flattened(world)), Verdict::accepted);
    EXPECT_NEAR(world.trial().places[0].t, -0.3, 1e-15);
    EXPECT_LE(world.trial().faces[1].range.lo, -0.3);
}

TEST(Validator, RefusesAVertexThatNoFaceReaches) {
    EXPECT_EQ(judge_top({1.25, 0.5, 0.3}), Verdict::no_preimage);
    EXPECT_EQ(judge_top({0.875, 0.5, 0.3}), Verdict::accepted);
}

// Directions towards a point at height 1 above the square: nothing beyond it is reached without a fold.
TEST(Validator, RefusesAVertexBeyondTheFold) {
    for (const auto& [height, verdict] : {std::pair{0.75, Verdict::accepted}, std::pair{1.25, Verdict::no_preimage}}) {
        World world(pyramid({0.55, 0.45, height}));
        for (const std::int32_t v : {0, 1, 2, 3}) {
            world.base().set_direction(v, Vec3(0.5, 0.5, 1) - world.scan().positions[v]);
        }
        EXPECT_EQ(world.judge(flattened(world)), verdict) << height;
    }
}

TEST(Validator, RefusesATopAboveTheBorderAsATie) {
    EXPECT_EQ(judge_top({0.5, 0, 0.3}), Verdict::tie);
    EXPECT_EQ(judge_top({0.5, 0x1p-10, 0.3}), Verdict::accepted);
}

// The scan edges 0-4 and 2-4 lie in the wall over the diagonal, though they are no base edges.
TEST(Validator, AcceptsScanEdgesAlongAWall) {
    EXPECT_EQ(judge_top({0.5, 0.5, 0.3}), Verdict::accepted);
    EXPECT_EQ(judge_top({0.5, 0.5 + 0x1p-20, 0.3}), Verdict::accepted);
}

TEST(Validator, RefusesAFaceThatFoldsAtOnce) {
    for (const auto& [direction, verdict] :
         {std::pair{Vec3(0.1, 0.2, 1), Verdict::accepted}, std::pair{Vec3(0.1, 0.2, -1), Verdict::jacobian},
          std::pair{Vec3(1, 0, 0), Verdict::jacobian}}) {
        World world(pyramid({0.4, 0.7, 0.3}));
        Patch patch = flattened(world);
        patch.changed.push_back({2, {world.scan().positions[2], direction, 2}});
        EXPECT_EQ(world.judge(patch), verdict) << direction.transpose();
    }
}

// Four faces around 4 and 5 over the square, cut the other way so that 4 and 5 lie in different faces seen from 1 and
// 3:
//
//     3 ------- 2       3 ------- 2
//     | \  \  / |       | \       |
//     |  4 - 5  |  ->   |   \     |
//     | /  \  \ |       |     \   |
//     0 ------- 1       0 ------- 1
Scan two_tops(const Vec3& first, const Vec3& second) {
    Scan scan = pyramid(first);
    scan.positions.push_back(second);
    scan.faces = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}};
    return scan;
}

Verdict judge_two_tops(const Vec3& first, const Vec3& second, const std::vector<Triangle>& faces) {
    World world(two_tops(first, second));
    Patch patch = world.replacing_all(faces);
    patch.changed.push_back(moved(4, first));
    patch.changed.push_back(moved(5, second));
    return world.judge(patch);
}

// In the wrong order the face between them is seen from behind.
TEST(Validator, RefusesScanEdgesInTheWrongOrderAroundAKeptVertex) {
    const std::vector<Triangle> faces{{0, 1, 3}, {1, 2, 3}};
    EXPECT_EQ(judge_two_tops({0.35, 0.4, 0.1}, {0.6, 0.65, 0.1}, faces), Verdict::accepted);
    EXPECT_EQ(judge_two_tops({0.6, 0.65, 0.1}, {0.35, 0.4, 0.1}, faces), Verdict::normal_condition);
}

// Every scan face is seen from in front, but around the poles they go round twice.
TEST(Validator, RefusesAScanThatGoesRoundAKeptVertexTwice) {
    World once(spindle(7, 1));
    EXPECT_EQ(once.judge(bipyramid(once, 4)), Verdict::accepted);
    World twice(spindle(7, 2));
    EXPECT_EQ(twice.judge(bipyramid(twice, 4)), Verdict::orientation);
}

// Seen from above 4 and 5 change sides within one face: the faces between them are seen from behind.
TEST(Validator, RefusesAScanFaceSeenFromBehind) {
    EXPECT_EQ(judge_two_tops({0.25, 0.5, 0.1}, {0.75, 0.625, 0.1}, square), Verdict::accepted);
    EXPECT_EQ(judge_two_tops({0.75, 0.625, 0.1}, {0.25, 0.5, 0.1}, square), Verdict::normal_condition);
}

// The top hangs over the edge 1-2: no height field, but seen from the right direction.
TEST(Validator, AcceptsAnOverhangThatTheDirectionsSee) {
    for (const auto& [tilt, verdict] : {std::pair{0.0, Verdict::no_preimage}, std::pair{1.0, Verdict::accepted},
                                        std::pair{3.0, Verdict::no_preimage}}) {
        World world(pyramid({1.25, 0.5, 0.5}), Vec3(tilt, 0, 1));
        EXPECT_EQ(world.judge(flattened(world)), verdict) << tilt;
    }
}

TEST(Validator, RefusesADisplacementLongerThanAllowed) {
    EXPECT_EQ(judge_top({0.4, 0.7, 0.3}, at_most(0.25)), Verdict::max_displacement);
    EXPECT_EQ(judge_top({0.4, 0.7, -0.3}, at_most(0.25)), Verdict::max_displacement);
    EXPECT_EQ(judge_top({0.4, 0.7, 0.3}, at_most(0.3125)), Verdict::accepted);
}

TEST(Validator, MeasuresDisplacementsInModelUnits) {
    for (const auto& [length, bound] : {std::pair{8.0, 0.25}, std::pair{0.125, 0.25}}) {
        World world(pyramid({0.4, 0.7, 0.3}), Vec3(0, 0, length));
        EXPECT_EQ(world.judge(flattened(world), at_most(bound)), Verdict::max_displacement) << length;
        EXPECT_EQ(world.judge(flattened(world), at_most(0.3125)), Verdict::accepted) << length;
    }
}

// A channel: the triangles A (at x = 0, 1.2 high) and C (at x = 1, 4 high) face each other across the floor. Before A a
// top q, before C, far above A, a top r. q lies 0.55 in front of C too, r 0.6: as C must reach r, it reaches q as well.
//
//            C |            0 1  A below (y = 0, 1), 2 above
//           r- |            3 4  C below (y = 0, 1), 5 above
//     |        |            6 = q, 7 = r
//     |  q     |
//     A -------
Scan channel(double q) {
    return {{{0, 0, 0}, {0, 1, 0}, {0, 0.5, 1.2}, {1, 0, 0}, {1, 1, 0}, {1, 0.5, 4}, {q, 0.5, 0.7}, {0.4, 0.5, 2.5}},
            {{0, 1, 6}, {1, 2, 6}, {2, 0, 6}, {4, 3, 7}, {3, 5, 7}, {5, 4, 7}, {0, 3, 4}, {0, 4, 1}},
            false};
}

Verdict judge_channel(double q, Uniqueness uniqueness) {
    World world(channel(q));
    const std::vector<Vec3> directions{{1, 0, 1}, {1, 0, 1}, {1, 0, 0}, {-1, 0, 1}, {-1, 0, 1}, {-1, 0, 0}};
    for (std::size_t v = 0; v < directions.size(); ++v) {
        world.base().set_direction(static_cast<std::int32_t>(v), directions[v]);
    }
    Patch patch;
    patch.removed = {0, 1, 2, 3, 4, 5};
    patch.added = {{{0, 1, 2}, -1}, {{4, 3, 5}, -1}};
    patch.changed = {moved(6, world.scan().positions[6]), moved(7, world.scan().positions[7])};
    ValidatorOptions options;
    options.uniqueness = uniqueness;
    return world.judge(patch, options);
}

TEST(Validator, RefusesASecondPlaceWithinTheRanges) {
    EXPECT_EQ(judge_channel(0.45, Uniqueness::in_range), Verdict::several_preimages);
}

TEST(Validator, AcceptsASecondPlaceBeyondTheRanges) {
    EXPECT_EQ(judge_channel(0.35, Uniqueness::in_range), Verdict::accepted);
    EXPECT_EQ(judge_channel(0.35, Uniqueness::fold_free), Verdict::several_preimages);
}

// Two squares with a top each, P and Q, and a scan edge between the tops:
//
//     F ------- E ------- D       A 0, B 1, C 2, D 3, E 4, F 5
//     |  P ---- | ---- Q  |       P 6, Q 7
//     A ------- B ------- C
//
// Q goes into E first, so that the faces to the right are base faces with a range; then P into A.
Scan two_squares() {
    return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.4, 0.4}, {1.5, 0.6, 0.2}},
            {{0, 1, 6}, {1, 7, 6}, {1, 2, 7}, {2, 3, 7}, {3, 4, 7}, {4, 6, 7}, {4, 5, 6}, {5, 0, 6}},
            false};
}

class BesideABaseFace : public testing::Test {
protected:
    void SetUp() override {
        const Patch right = world_.collapse_patch(7, 4);
        ASSERT_EQ(world_.judge(right), Verdict::accepted);
        world_.commit_collapse(7, 4, right);
    }

    /// The base face outside the second patch that has the edge B-E.
    std::int32_t beside() {
        for (std::int32_t f = 0; f < 8; ++f) {
            const auto handle = OpenMesh::FaceHandle(f);
            const Triangle corners = world_.base().corners(f);
            const auto has = [&](std::int32_t v) {
                return std::find(corners.begin(), corners.end(), v) != corners.end();
            };
            if (!world_.base().connectivity().status(handle).deleted() && has(1) && has(4) && !has(6)) {
                return f;
            }
        }
        throw std::logic_error("no face beside the edge B-E");
    }

    void set_range_beside(const Range& range) {
        BaseFace face = world_.base().face(beside());
        const std::vector<std::int32_t> scan_faces(face.scan_faces.begin(), face.scan_faces.end());
        face.range = range;
        face.scan_faces = scan_faces;
        world_.base().set_face(beside(), face);
    }

    Verdict judge_left() { return world_.judge(world_.collapse_patch(6, 0)); }

    World world_{two_squares()};
};

TEST_F(BesideABaseFace, FollowsScanEdgesIntoIt) {
    EXPECT_EQ(judge_left(), Verdict::accepted);
    ASSERT_EQ(world_.trial().places.size(), 1); // the place of Q does not change
    EXPECT_EQ(world_.trial().places[0].scan_vertex, 6);
}

TEST_F(BesideABaseFace, RefusesADisplacementOutsideItsRange) {
    const Range range = world_.base().face(beside()).range;
    EXPECT_NEAR(range.hi, 0.3, 1e-7); // where the edge P-Q passes over B-E
    set_range_beside({0.0, to_float32(0.29)});
    EXPECT_EQ(judge_left(), Verdict::out_of_range);
    set_range_beside({0.0, to_float32(0.31)});
    EXPECT_EQ(judge_left(), Verdict::accepted);
}

TEST_F(BesideABaseFace, EntersNoFaceThatRepresentsItself) {
    world_.base().set_face(beside(), {{0.0, 0.0}, {}, -1, true});
    EXPECT_EQ(judge_left(), Verdict::no_preimage);
}

// Each face along its own normal: a scan face must lie over one base face.
TEST(ValidatorOfConstantDirections, AcceptsScanFacesWithinOneBaseFace) {
    const Scan scan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.4, 0.25}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, false};
    World world(scan);
    Patch patch = world.replacing_all({{0, 1, 2}});
    patch.changed.push_back(moved(3, scan.positions[3]));
    EXPECT_EQ(world.judge(patch, constant_directions()), Verdict::accepted);
    EXPECT_THAT(world.trial().faces[0].scan_faces, ElementsAre(0, 1, 2));
    EXPECT_GE(world.trial().faces[0].range.hi, 0.25);
    EXPECT_LE(world.trial().faces[0].range.lo, 0); // where the corners are, which are kept
}

TEST(ValidatorOfConstantDirections, RefusesAScanFaceOverTwoBaseFaces) {
    EXPECT_EQ(judge_top({0.4, 0.7, 0.3}, constant_directions()), Verdict::no_preimage);
}

} // namespace
} // namespace foldless
