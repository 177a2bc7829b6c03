// Closed meshes: stars around the origin over an octahedron, and faults that each break one condition.

#include "made_meshes.h"
#include "violations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foldless {
namespace {

using namespace test;
using testing::AllOf;

/// The vertex in the middle of the first octant: its star lies within one base face.
std::int32_t some_vertex(const Scan& scan) {
    std::int32_t best = 0;
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        const bool nearer = scan.positions[v].normalized().sum() > scan.positions[best].normalized().sum();
        best = nearer ? static_cast<std::int32_t>(v) : best;
    }
    return best;
}

/// Any other corner of a face around the vertex.
std::int32_t neighbour_of(const Scan& scan, std::int32_t vertex) {
    for (const Triangle& face : scan.faces) {
        const auto corner = std::find(face.begin(), face.end(), vertex);
        if (corner != face.end()) {
            return face[(corner - face.begin() + 1) % 3];
        }
    }
    return -1;
}

/// A second mesh beside the first, as one mesh.
Scan joined(const Scan& a, const Scan& b) {
    Scan both = a;
    const auto shift = static_cast<std::int32_t>(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& [i, j, k] : b.faces) {
        both.faces.push_back({i + shift, j + shift, k + shift});
    }
    return both;
}

Scan scaled(Scan scan, double factor) {
    for (Vec3& p : scan.positions) {
        p *= factor;
    }
    return scan;
}

Scan moved(Scan scan, const Vec3& by) {
    for (Vec3& p : scan.positions) {
        p += by;
    }
    return scan;
}

/// Two octahedra, the second one moved far away.
BaseMesh two_octahedra(const Vec3& by) {
    BaseMesh base = octahedron({-0.5, 2.5});
    const BaseMesh one = base;
    for (std::size_t v = 0; v < 6; ++v) {
        base.positions.push_back(one.positions[v] + by);
    }
    base.directions.insert(base.directions.end(), one.directions.begin(), one.directions.end());
    base.scan_vertex.insert(base.scan_vertex.end(), 6, -1);
    for (const auto& [i, j, k] : one.faces) {
        base.faces.push_back({i + 6, j + 6, k + 6});
    }
    base.ranges.insert(base.ranges.end(), one.ranges.begin(), one.ranges.end());
    return base;
}

class SphereTest : public testing::TestWithParam<int> {};

TEST_P(SphereTest, IsRepresentedByAnOctahedron) {
    EXPECT_THAT(verify(octahedron(), turned_sphere(GetParam())), IsCertified());
}

TEST_P(SphereTest, IsRepresentedWithItsElementsOnWallsAndPillars) {
    EXPECT_THAT(verify(octahedron(), aligned_sphere(GetParam())), IsCertified());
}

INSTANTIATE_TEST_SUITE_P(Levels, SphereTest, testing::Values(1, 2, 3, 4));

TEST(Verify, CertifiesScanTrianglesThatHoldPillars) {
    EXPECT_THAT(verify(octahedron({-0.9, 3}), turned_sphere(0)), IsCertified());
}

TEST(Verify, SeesNoDifferenceInTheUnitOfLengthOrTheCornerThatIsFirst) {
    for (const double factor : {0x1p-60, 0x1p40}) {
        BaseMesh base = octahedron();
        for (std::size_t v = 0; v < base.positions.size(); ++v) {
            base.positions[v] *= factor;
            base.directions[v] *= factor;
        }
        for (std::size_t f = 0; f < base.faces.size(); f += 2) {
            std::rotate(base.faces[f].begin(), base.faces[f].begin() + 1, base.faces[f].end());
        }
        EXPECT_THAT(verify(base, scaled(turned_sphere(2), factor)), IsCertified());
    }
}

TEST(Verify, CertifiesFarFromTheOrigin) {
    const Vec3 far(1024, -2048, 512);
    BaseMesh base = octahedron();
    for (Vec3& p : base.positions) {
        p += far;
    }
    EXPECT_THAT(verify(base, moved(turned_sphere(3), far)), IsCertified());
}

TEST(Verify, FindsAReversedDirection) {
    BaseMesh base = octahedron();
    base.directions[2] = -base.directions[2];
    EXPECT_THAT(verify(base, turned_sphere(2)), Has(Violation::jacobian));
    base.directions[2] = {0.1, 1, -0.1}; // a little aslant is no fault
    EXPECT_THAT(verify(base, turned_sphere(2)), IsCertified());
}

TEST(Verify, FindsARangeInWhichTheMapFolds) {
    BaseMesh base = octahedron();
    base.ranges[3] = {-1.5, 1.5}; // all corners meet in the origin at t = -1
    EXPECT_THAT(verify(base, turned_sphere(2)), Has(Violation::jacobian));
    base.ranges[3] = {-0.999, 1.5};
    EXPECT_THAT(verify(base, turned_sphere(2)), IsCertified());
}

TEST(Verify, FindsVerticesBeyondTheRange) {
    EXPECT_THAT(verify(octahedron({-0.5, 0.4}), turned_sphere(3)), Has(Violation::no_preimage));
    EXPECT_THAT(verify(octahedron({-0.5, 0.9}), turned_sphere(3)), IsCertified());
}

TEST(Verify, FindsAnEdgeThatLeavesTheRangeBetweenItsEnds) {
    // Six vertices over eight faces: a face without any has walls that edges cross.
    const Scan scan = turned_sphere(0);
    int faults = 0;
    for (std::size_t f = 0; f < 8; ++f) {
        BaseMesh base = octahedron({-0.9, 3});
        base.ranges[f] = {2, 3};
        const VerifyResult result = verify(base, scan);
        if (count(result, Violation::no_preimage) == 0) {
            EXPECT_THAT(result, Has(Violation::trace));
            ++faults;
        }
    }
    EXPECT_GE(faults, 2);
}

TEST(Verify, FindsAHoleInTheBaseMesh) {
    BaseMesh base = octahedron();
    base.faces.pop_back();
    base.ranges.pop_back();
    EXPECT_THAT(verify(base, turned_sphere(2)), Has(Violation::topology));
}

TEST(Verify, FindsVerticesThatChangedPlaces) {
    Scan scan = turned_sphere(3);
    const std::int32_t a = some_vertex(scan);
    std::swap(scan.positions[a], scan.positions[neighbour_of(scan, a)]);
    EXPECT_THAT(verify(octahedron(), scan), HasOnly(Violation::normal_condition));
}

TEST(Verify, FindsAVertexPushedOverItsNeighbours) {
    const Scan scan = turned_sphere(3);
    const std::int32_t a = some_vertex(scan);
    const Vec3 step = scan.positions[neighbour_of(scan, a)] - scan.positions[a];
    Scan pushed = scan;
    pushed.positions[a] += 1.5 * step;
    EXPECT_THAT(verify(octahedron(), pushed), Has(Violation::normal_condition));
    pushed.positions[a] = scan.positions[a] + 0.5 * step;
    EXPECT_THAT(verify(octahedron(), pushed), IsCertified());
}

TEST(Verify, FindsAScanTurnedInsideOut) {
    Scan scan = turned_sphere(2);
    for (Triangle& face : scan.faces) {
        std::swap(face[1], face[2]);
    }
    EXPECT_THAT(verify(octahedron(), scan), AllOf(Has(Violation::normal_condition), Has(Violation::degree)));
}

TEST(Verify, FindsTwoSheetsOverOneComponentByItsDegreeAlone) {
    const Vec3 far(100, 0, 0);
    const Scan sphere = turned_sphere(2);
    EXPECT_THAT(verify(two_octahedra(far), joined(sphere, moved(sphere, far))), IsCertified());
    // Both spheres around the first octahedron: every vertex, edge and face is in order.
    EXPECT_THAT(verify(two_octahedra(far), joined(sphere, scaled(sphere, 1.5))), HasOnly(Violation::degree));
}

TEST(Verify, FindsAStarThatWindsTwiceAroundAKeptVertex) {
    const Scan triangle = bipyramid(3, 1);
    BaseMesh base;
    base.positions = triangle.positions;
    base.directions = triangle.positions;
    base.scan_vertex = {0, 1, -1, -1, -1};
    base.faces = triangle.faces;
    base.ranges.assign(base.faces.size(), {-0.6, 2});
    EXPECT_THAT(verify(base, bipyramid(9, 1)), IsCertified());
    const VerifyResult twice = verify(base, bipyramid(9, 2));
    EXPECT_THAT(twice, HasOnly(Violation::orientation));
}

TEST(Verify, FindsADoubleCoverWithoutKeptVerticesByItsDegreeAlone) {
    // Two laps around the axis: every scan triangle is mapped one to one, and the poles are branch points.
    const Scan triangle = bipyramid(3, 1);
    BaseMesh base;
    base.positions = triangle.positions;
    base.directions = triangle.positions;
    base.scan_vertex.assign(5, -1);
    base.faces = triangle.faces;
    base.ranges.assign(base.faces.size(), {-0.8, 2});
    for (const int laps : {1, 2}) {
        Scan scan = bipyramid(9, laps);
        scan.positions[0] += Vec3(0.05, 0.03, 0); // beside the pillars of the base mesh
        scan.positions[1] += Vec3(0.02, -0.04, 0);
        for (std::size_t v = 2; v < scan.positions.size(); ++v) {
            scan.positions[v] += Vec3(0.01, 0.02, 0.005);
        }
        const VerifyResult result = verify(base, scan);
        if (laps == 1) {
            EXPECT_THAT(result, IsCertified());
            EXPECT_EQ(result.level, Level::surface);
        } else {
            EXPECT_THAT(result, HasOnly(Violation::degree));
        }
    }
}

TEST(Verify, CountsTheSignsThatNeedExactNumbers) {
    if (!filters_enabled()) {
        GTEST_SKIP() << "without filters all of them do";
    }
    const VerifyResult turned = verify(octahedron(), turned_sphere(2));
    EXPECT_GT(turned.signs.filtered, turned.signs.exact);
    EXPECT_GT(verify(octahedron(), aligned_sphere(2)).signs.exact, turned.signs.exact);
}

} // namespace
} // namespace foldless
