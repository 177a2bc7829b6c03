// Whole runs on generated scans.

#include "deep_check.h"
#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/errors.h>
#include <foldless/predicates/visible_direction.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace foldless {
namespace {

using namespace test;

DecimateResult checked(const Scan& scan, const DecimateOptions& options = {}) {
    DecimateResult result = decimate(scan, options);
    deep_check(scan, options, result);
    return result;
}

std::size_t refusals(const DecimateResult& result, Verdict verdict) {
    return result.statistics.refused[static_cast<std::size_t>(verdict)];
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    // memcmp() may not be called for nothing, which is what data() of an empty vector is.
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const DecimateResult& a, const DecimateResult& b) {
    EXPECT_TRUE(same_bytes(a.base.positions, b.base.positions));
    EXPECT_TRUE(same_bytes(a.base.directions, b.base.directions));
    EXPECT_TRUE(same_bytes(a.base.face_directions, b.base.face_directions));
    EXPECT_TRUE(same_bytes(a.base.scan_vertex, b.base.scan_vertex));
    EXPECT_TRUE(same_bytes(a.base.faces, b.base.faces));
    EXPECT_TRUE(same_bytes(a.base.ranges, b.base.ranges));
    EXPECT_TRUE(same_bytes(a.correspondence.base_face, b.correspondence.base_face));
    EXPECT_TRUE(same_bytes(a.correspondence.alpha, b.correspondence.alpha));
    EXPECT_TRUE(same_bytes(a.correspondence.t, b.correspondence.t));
    EXPECT_EQ(a.statistics.refused, b.statistics.refused);
    EXPECT_EQ(a.statistics.attempted, b.statistics.attempted);
}

TEST(Decimate, ReducesAClosedScanUntilEveryEdgeIsRefused) {
    const Scan scan = bumpy_sphere(4);
    const DecimateResult result = checked(scan);
    EXPECT_EQ(result.stop_reason, StopReason::every_edge_refused);
    EXPECT_LE(result.base.faces.size(), 40);
    EXPECT_EQ(scan.faces.size() - 2 * result.statistics.accepted, result.base.faces.size());
    EXPECT_GE(result.statistics.attempted, result.statistics.accepted);
    EXPECT_EQ(result.statistics.unserved_vertices, 0);
}

TEST(Decimate, KeepsTheGenusOfATorus) {
    const Scan scan = torus(30, 14);
    EXPECT_LE(checked(scan).base.faces.size(), 120);
}

TEST(Decimate, KeepsALockedBorderEdgeForEdge) {
    const int side = 16;
    const DecimateResult result = checked(terrain(side, 0.1));
    EXPECT_GT(refusals(result, Verdict::boundary), 0);
    EXPECT_LE(result.base.faces.size(), static_cast<std::size_t>(6 * side));
    EXPECT_GE(result.base.faces.size(), static_cast<std::size_t>(4 * side - 2)); // a triangulated polygon has as many
}

// Nothing but ties: every scan vertex that is not kept lies in the plane of the base mesh, most on a base edge.
TEST(Decimate, ReducesAFlatGrid) {
    const DecimateResult result = checked(terrain(10, 0));
    EXPECT_LE(result.base.faces.size(), 100);
    for (const double t : result.correspondence.t) {
        EXPECT_EQ(t, 0);
    }
    // A vertex on the rim of a patch belongs to one cell for all scan edges that start at it.
    for (const Verdict verdict : {Verdict::no_preimage, Verdict::normal_condition, Verdict::out_of_range}) {
        EXPECT_EQ(refusals(result, verdict), 0) << name(verdict);
    }
}

TEST(Decimate, ReachesTheTarget) {
    const Scan scan = bumpy_sphere(3);
    for (const std::size_t target : {500U, 301U, 100U}) {
        DecimateOptions options;
        options.target_faces = target;
        const DecimateResult result = checked(scan, options);
        EXPECT_EQ(result.stop_reason, StopReason::target_reached);
        EXPECT_LE(result.base.faces.size(), target);
        EXPECT_GE(result.base.faces.size() + 1, target); // a collapse takes two faces
    }
}

TEST(Decimate, GivesTheScanItselfWhenNothingMustGo) {
    const Scan scan = terrain(5, 0.2);
    for (const std::size_t target : {scan.faces.size(), scan.faces.size() + 1, std::size_t{1000000}}) {
        DecimateOptions options;
        options.target_faces = target;
        const DecimateResult result = checked(scan, options);
        EXPECT_EQ(result.stop_reason, StopReason::target_reached);
        EXPECT_EQ(result.base.positions, scan.positions);
        ASSERT_EQ(result.base.faces.size(), scan.faces.size());
        for (std::size_t f = 0; f < scan.faces.size(); ++f) {
            EXPECT_EQ(std::set<std::int32_t>(result.base.faces[f].begin(), result.base.faces[f].end()),
                      std::set<std::int32_t>(scan.faces[f].begin(), scan.faces[f].end()));
            EXPECT_EQ(result.base.ranges[f].lo, 0);
            EXPECT_EQ(result.base.ranges[f].hi, 0);
        }
        EXPECT_EQ(result.statistics.attempted, 0);
    }
}

TEST(Decimate, LeavesOutVerticesThatNoFaceUses) {
    Scan scan = terrain(6, 0.1);
    scan.positions.insert(scan.positions.begin(), Vec3(9, 9, 9));
    scan.positions.emplace_back(-9, 0, 0);
    for (Triangle& face : scan.faces) {
        for (std::int32_t& v : face) {
            ++v;
        }
    }
    const DecimateResult result = checked(scan);
    EXPECT_EQ(result.correspondence.base_face.front(), -1);
    EXPECT_EQ(result.correspondence.base_face.back(), -1);
}

TEST(Decimate, StaysWithinTheAllowedDisplacement) {
    const Scan scan = bumpy_sphere(4);
    std::size_t faces = 0;
    for (const double bound : {0.2, 0.02, 0.002}) {
        DecimateOptions options;
        options.max_displacement = bound;
        const DecimateResult result = checked(scan, options);
        EXPECT_GT(refusals(result, Verdict::max_displacement), 0);
        for (std::size_t f = 0; f < result.base.faces.size(); ++f) {
            const Range range = result.base.ranges[f];
            for (const std::int32_t v : result.base.faces[f]) {
                EXPECT_LE(std::max(-range.lo, range.hi) * result.base.directions[v].norm(), bound);
            }
        }
        EXPECT_GT(result.base.faces.size(), faces); // the tighter, the more
        faces = result.base.faces.size();
    }
}

TEST(Decimate, IsValidWhenTheTimeIsUpAtOnce) {
    DecimateOptions options;
    options.time_limit = 0.0;
    const Scan scan = bumpy_sphere(3);
    const DecimateResult result = checked(scan, options);
    EXPECT_EQ(result.stop_reason, StopReason::time_limit);
    EXPECT_EQ(result.base.faces.size(), scan.faces.size());
}

TEST(Decimate, IsValidWhereverTheProgressFunctionStopsIt) {
    const Scan scan = bumpy_sphere(3);
    std::size_t before = scan.faces.size() + 1;
    for (const int calls : {1, 2, 4}) {
        int called = 0;
        DecimateOptions options;
        options.progress = [&](const Progress& progress) {
            EXPECT_EQ(progress.input_faces, scan.faces.size());
            EXPECT_EQ(progress.target, 0);
            EXPECT_LE(progress.faces, scan.faces.size());
            return ++called < calls;
        };
        const DecimateResult result = checked(scan, options);
        EXPECT_EQ(result.stop_reason, StopReason::cancelled);
        EXPECT_EQ(called, calls);
        EXPECT_LT(result.base.faces.size(), before);
        before = result.base.faces.size();
    }
}

TEST(Decimate, CallsTheProgressFunctionWithFewerAndFewerFaces) {
    DecimateOptions options;
    options.target_faces = 100;
    std::vector<std::size_t> faces;
    options.progress = [&](const Progress& progress) {
        EXPECT_EQ(progress.target, 100);
        faces.push_back(progress.faces);
        return true;
    };
    static_cast<void>(decimate(bumpy_sphere(3), options));
    EXPECT_GT(faces.size(), 3);
    EXPECT_TRUE(std::is_sorted(faces.rbegin(), faces.rend()));
}

TEST(Decimate, GivesTheSameBytesForAnyNumberOfThreads) {
    for (const Scan& scan : {bumpy_sphere(4), terrain(20, 0.1)}) {
        DecimateOptions options;
        const DecimateResult first = decimate(scan, options);
        expect_same(first, decimate(scan, options));
        for (const int threads : {1, 2, 4}) {
            options.threads = threads;
            expect_same(first, decimate(scan, options));
        }
    }
}

// Every decision is a comparison of polynomials in the coordinates, so a power of two changes none.
TEST(Decimate, LeavesTheScanAsItWasInPlace) {
    const Scan scan = bumpy_sphere(3);
    Scan used = scan;
    const DecimateResult result = decimate_in_place(used);
    expect_same(result, decimate(scan));
    EXPECT_TRUE(same_bytes(used.positions, scan.positions));
    EXPECT_TRUE(same_bytes(used.faces, scan.faces));
}

TEST(Decimate, GivesTheSameFacesAtAnyPowerOfTwo) {
    const Scan scan = bumpy_sphere(3);
    const DecimateResult first = decimate(scan);
    for (const double scale : {0x1p-20, 0x1p10, 0x1p40}) {
        Scan scaled = scan;
        for (Vec3& p : scaled.positions) {
            p *= scale;
        }
        const DecimateResult result = checked(scaled);
        EXPECT_TRUE(same_bytes(result.base.faces, first.base.faces)) << scale;
        EXPECT_TRUE(same_bytes(result.base.scan_vertex, first.base.scan_vertex)) << scale;
        EXPECT_TRUE(same_bytes(result.base.directions, first.base.directions)) << scale;
        ASSERT_EQ(result.base.positions.size(), first.base.positions.size());
        for (std::size_t v = 0; v < first.base.positions.size(); ++v) {
            EXPECT_EQ(result.base.positions[v], scale * first.base.positions[v]) << scale;
        }
    }
}

TEST(Decimate, HoldsCoordinatesThatFloat32CannotHold) {
    Scan scan = bumpy_sphere(3);
    scan.float32 = false;
    for (Vec3& p : scan.positions) {
        p = p / 3 + Vec3(1000, -2000, 3000);
    }
    EXPECT_LE(checked(scan).base.faces.size(), 100);
}

TEST(Decimate, FreezesFacesAtAVertexThatNoDirectionServesAsFewAsItMust) {
    const Scan scan = skew_cubes(4);
    const std::int32_t unserved = vertex_at(scan, Vec3::Zero());
    ASSERT_GE(unserved, 0);
    const DecimateResult result = checked(scan);
    EXPECT_EQ(result.statistics.unserved_vertices, 1);
    EXPECT_GT(refusals(result, Verdict::frozen), 0);
    EXPECT_LT(result.base.faces.size(), scan.faces.size() / 2);
    std::set<std::set<std::int32_t>> frozen; // scan faces that are base faces, with range [0, 0]
    for (std::size_t f = 0; f < result.base.faces.size(); ++f) {
        std::set<std::int32_t> kept;
        for (const std::int32_t v : result.base.faces[f]) {
            kept.insert(result.base.scan_vertex[v]);
        }
        if (result.base.ranges[f].lo == 0 && result.base.ranges[f].hi == 0) {
            frozen.insert(kept);
        }
    }
    std::vector<Vec3> moving; // normals of the others around it
    std::size_t around = 0;
    for (const Triangle& face : scan.faces) {
        if (std::find(face.begin(), face.end(), unserved) != face.end()) {
            ++around;
            const Vec3 e1 = scan.positions[face[1]] - scan.positions[face[0]];
            const Vec3 e2 = scan.positions[face[2]] - scan.positions[face[0]];
            if (!frozen.contains({face.begin(), face.end()})) {
                moving.push_back(e1.cross(e2).normalized());
            }
        }
    }
    EXPECT_GE(around, 6);
    EXPECT_FALSE(moving.empty());
    EXPECT_LT(moving.size(), around);
    EXPECT_TRUE(most_visible_direction(moving));
}

TEST(Decimate, CountsEveryRefusalByItsVerdict) {
    const DecimateResult result = decimate(terrain(12, 0.3));
    EXPECT_EQ(refusals(result, Verdict::accepted), 0);
    std::size_t total = 0;
    for (const std::size_t count : result.statistics.refused) {
        total += count;
    }
    EXPECT_GE(total, result.statistics.attempted - result.statistics.accepted);
}

TEST(Decimate, StopsAtTheValenceLimit) {
    DecimateOptions options;
    options.edge_valence_limit = 9;
    const DecimateResult result = checked(bumpy_sphere(3), options);
    EXPECT_GT(refusals(result, Verdict::valence), 0);
    options.edge_valence_limit = 4;
    EXPECT_EQ(decimate(bumpy_sphere(2), options).statistics.accepted, 0);
}

Scan tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

// No edge of a tetrahedron may go: two faces on the same three vertices would be left.
TEST(Decimate, LeavesATetrahedronAlone) {
    for (const Directions directions : {Directions::visible, Directions::area, Directions::angle, Directions::face}) {
        for (const Placement placement : {Placement::best, Placement::midpoint}) {
            DecimateOptions options;
            options.directions = directions;
            options.placement = placement;
            EXPECT_EQ(checked(tetrahedron(), options).base.faces.size(), 4);
        }
    }
}

// The normals around the vertex that would be left of a tetrahedron's edge cancel: the only known way to this verdict.
TEST(Decimate, RefusesACollapseThatLeavesNoDirection) {
    const DecimateResult result = decimate(tetrahedron());
    EXPECT_GT(refusals(result, Verdict::direction) + refusals(result, Verdict::link_condition), 0);
}

TEST(DecimateRefuses, AScanWithADefect) {
    Scan scan = pyramid({0.4, 0.7, 0.3});
    scan.faces.push_back({0, 1, 4}); // a third face on two edges
    EXPECT_THROW(static_cast<void>(decimate(scan)), RefusedMesh);
    scan = pyramid({0.4, 0.7, 0.3});
    scan.positions[4].z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(decimate(scan)), RefusedMesh);
    scan = pyramid({0.4, 0.7, 0.3});
    scan.faces[2] = {3, 2, 4}; // turned over
    EXPECT_THROW(static_cast<void>(decimate(scan)), RefusedMesh);
    scan = pyramid({0.4, 0.7, 0.3});
    scan.faces.clear();
    EXPECT_THROW(static_cast<void>(decimate(scan)), RefusedMesh);
    scan = pyramid({0.4, 0.7, 0.3});
    scan.faces[0][0] = 17;
    EXPECT_THROW(static_cast<void>(decimate(scan)), RefusedMesh);
}

TEST(Decimate, FlattensAPyramid) {
    const DecimateResult result = checked(pyramid({0.4, 0.7, 0.3}));
    EXPECT_EQ(result.base.faces.size(), 2);
    EXPECT_EQ(result.statistics.accepted, 1);
}

TEST(Verdict, HasANameOfItsOwn) {
    std::set<std::string_view> names;
    for (std::size_t verdict = 0; verdict < verdict_count; ++verdict) {
        names.insert(name(static_cast<Verdict>(verdict)));
    }
    EXPECT_EQ(names.size(), verdict_count);
    EXPECT_EQ(name(Verdict::several_preimages), "several_preimages");
    EXPECT_FALSE(names.contains("unknown"));
}

} // namespace
} // namespace foldless
