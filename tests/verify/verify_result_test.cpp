// What the result says, who may ask, and that it does not depend on the threads.

#include "made_meshes.h"
#include "violations.h"

#include <foldless/io/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace foldless {
namespace {

using namespace test;

TEST(VerifyResult, SummarisesTheDisplacements) {
    const VerifyResult result = verify(square(), pyramid({0.4, 0.7, 0.3}));
    EXPECT_EQ(result.min_displacement, 0.0);
    EXPECT_DOUBLE_EQ(result.max_displacement, 0.3);
    EXPECT_DOUBLE_EQ(result.rms_displacement, 0.3 / std::sqrt(5.0));
    const VerifyResult below = verify(square(), pyramid({0.4, 0.7, -0.3}));
    EXPECT_DOUBLE_EQ(below.min_displacement, -0.3);
    EXPECT_EQ(below.max_displacement, 0.0);
}

TEST(VerifyResult, IsTheSameForAnyNumberOfThreads) {
    Scan scan = turned_sphere(4);
    for (std::size_t v = 0; v < scan.positions.size(); v += 7) {
        scan.positions[v] *= v % 2 == 0 ? 1.4 : 3.0; // spikes within and beyond the range
    }
    VerifyOptions options;
    options.threads = 1;
    const VerifyResult one = verify(octahedron(), scan, options);
    EXPECT_FALSE(one.certified());
    for (const int threads : {2, 4}) {
        options.threads = threads;
        const VerifyResult many = verify(octahedron(), scan, options);
        EXPECT_EQ(many.violations, one.violations);
        EXPECT_EQ(many.rms_displacement, one.rms_displacement);
        EXPECT_EQ(many.uncovered_fraction, one.uncovered_fraction);
        ASSERT_EQ(many.located.size(), one.located.size());
        for (std::size_t i = 0; i < one.located.size(); ++i) {
            EXPECT_EQ(many.located[i].violation, one.located[i].violation);
            EXPECT_EQ(many.located[i].scan_vertex, one.located[i].scan_vertex);
            EXPECT_EQ(many.located[i].scan_face, one.located[i].scan_face);
            EXPECT_EQ(many.located[i].base_face, one.located[i].base_face);
            EXPECT_EQ(many.located[i].position, one.located[i].position);
        }
    }
}

TEST(VerifyResult, LocatesTheFirstFewOfEachKind) {
    const VerifyResult result = verify(octahedron({-0.5, 0.2}), turned_sphere(3));
    const std::size_t missing = count(result, Violation::no_preimage);
    ASSERT_GT(missing, 8);
    std::vector<std::int32_t> located;
    for (const LocatedViolation& violation : result.located) {
        if (violation.violation == Violation::no_preimage) {
            located.push_back(violation.scan_vertex);
        }
    }
    EXPECT_EQ(located.size(), 8);
    EXPECT_TRUE(std::is_sorted(located.begin(), located.end()));
}

TEST(VerifyResult, StopsWhenAsked) {
    VerifyOptions options;
    std::vector<double> shares;
    options.progress = [&](double share) {
        shares.push_back(share);
        return shares.size() < 3;
    };
    const VerifyResult result = verify(octahedron(), turned_sphere(3), options);
    EXPECT_TRUE(result.cancelled);
    EXPECT_FALSE(result.certified());
    EXPECT_EQ(shares.size(), 3);
}

TEST(VerifyResult, ReportsProgressFromZeroToOne) {
    VerifyOptions options;
    std::vector<double> shares{0.0};
    options.progress = [&](double share) {
        EXPECT_GE(share, shares.back());
        shares.push_back(share);
        return true;
    };
    EXPECT_TRUE(verify(octahedron(), turned_sphere(2), options).certified());
    EXPECT_NEAR(shares.back(), 1.0, 0.11); // the share of the ranges is not used when they are stored
    EXPECT_LE(shares.back(), 1.0);
}

TEST(VerifyResult, NamesEveryViolation) {
    std::set<std::string_view> names;
    for (std::size_t kind = 0; kind < violation_count; ++kind) {
        names.insert(name(static_cast<Violation>(kind)));
    }
    EXPECT_EQ(names.size(), violation_count);
    EXPECT_EQ(name(Violation::normal_condition), "normal_condition");
}

TEST(VerifyRefuses, ABaseMeshWithoutDirections) {
    BaseMesh base = octahedron();
    base.directions.clear();
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
    base.directions.assign(5, {0, 0, 1});
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
    base = octahedron();
    base.directions[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
}

TEST(VerifyRefuses, ArraysOfAnotherLength) {
    BaseMesh base = octahedron();
    base.ranges.pop_back();
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
    base = octahedron();
    base.scan_vertex.pop_back();
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
    base = octahedron();
    base.face_directions.assign(3, {0, 0, 1});
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
}

TEST(VerifyRefuses, MeshesWithDefects) {
    Scan scan = turned_sphere(1);
    scan.faces[4] = {1, 1, 2};
    EXPECT_THROW((void)verify(octahedron(), scan), RefusedMesh);
    BaseMesh base = octahedron();
    base.faces[0] = {0, 2, 99};
    EXPECT_THROW((void)verify(base, turned_sphere(1)), RefusedMesh);
    EXPECT_THROW((void)verify(octahedron(), Scan{}), RefusedMesh);
}

} // namespace
} // namespace foldless
