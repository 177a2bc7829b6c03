#include <foldless/report/displacement.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {

namespace {

// One base triangle whose directions have the lengths 1, 2 and 3.
BaseMesh one_triangle() {
    BaseMesh base;
    base.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    base.directions = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
    base.faces = {{0, 1, 2}};
    return base;
}

TEST(DisplacementStatistics, ScalesTByTheLengthOfTheInterpolatedDirection) {
    const Correspondence correspondence{{0, 0}, {{1, 0, 0}, {0, 0.5, 0.5}}, {0.5, -0.4}};
    const DisplacementStatistics statistics = displacement_statistics(one_triangle(), correspondence, 10.0);
    EXPECT_DOUBLE_EQ(statistics.max, 0.5);
    EXPECT_DOUBLE_EQ(statistics.min, -1.0);
    EXPECT_DOUBLE_EQ(statistics.rms, std::sqrt((0.25 + 1.0) / 2.0));
    EXPECT_DOUBLE_EQ(statistics.max_relative_to_diagonal, 0.1);
}

TEST(DisplacementStatistics, LeavesOutVerticesThatNoFaceUses) {
    const Correspondence correspondence{{-1, 0}, {{0, 0, 0}, {1, 0, 0}}, {100.0, 0.5}};
    const DisplacementStatistics statistics = displacement_statistics(one_triangle(), correspondence, 10.0);
    EXPECT_EQ(statistics.min, 0.5);
    EXPECT_EQ(statistics.max, 0.5);
    EXPECT_EQ(statistics.rms, 0.5);
}

TEST(DisplacementStatistics, UsesTheDirectionOfTheFaceWhereThereIsOne) {
    BaseMesh base = one_triangle();
    base.directions.clear();
    base.face_directions = {{0, 0, 4}};
    const Correspondence correspondence{{0}, {{0.25, 0.25, 0.5}}, {0.5}};
    EXPECT_EQ(displacement_statistics(base, correspondence, 10.0).max, 2.0);
}

TEST(DisplacementStatistics, AreZeroWithoutScanVertices) {
    const DisplacementStatistics statistics = displacement_statistics(one_triangle(), {}, 0.0);
    EXPECT_EQ(statistics.min, 0.0);
    EXPECT_EQ(statistics.max, 0.0);
    EXPECT_EQ(statistics.rms, 0.0);
    EXPECT_EQ(statistics.max_relative_to_diagonal, 0.0);
}

} // namespace

} // namespace foldless
