// Meshes with borders, kept vertices and frozen faces, and meshes with constant face directions.

#include "made_meshes.h"
#include "violations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foldless {
namespace {

using namespace test;
using testing::AllOf;

BaseMesh square_without_kept_vertices(Range range) {
    BaseMesh base = square(range);
    base.scan_vertex.assign(4, -1);
    return base;
}

TEST(Verify, CertifiesALockedBorder) {
    const VerifyResult result = verify(square(), pyramid({0.4, 0.7, 0.3}));
    EXPECT_THAT(result, IsCertified());
    EXPECT_EQ(result.uncovered_fraction, 0.0);
    EXPECT_EQ(result.frozen_faces, 0);
}

TEST(Verify, CertifiesAVertexOnAWallAndEdgesAlongIt) {
    EXPECT_THAT(verify(square(), pyramid({0.5, 0.5, 0.3})), IsCertified());
}

TEST(Verify, CertifiesAFlatScanWithinAnEmptyRange) {
    EXPECT_THAT(verify(square({0, 0}), pyramid({0.5, 0.5, 0})), IsCertified());
    EXPECT_THAT(verify(square_without_kept_vertices({0, 0}), grid(8, 0.25, 0.75, 0)), IsCertified());
}

TEST(Verify, TellsTheShareOfATrimmedBaseMeshThatIsNotCovered) {
    const VerifyResult result = verify(square_without_kept_vertices({-1, 1}), grid(8, 0.25, 0.75, 0.5));
    EXPECT_THAT(result, IsCertified());
    EXPECT_DOUBLE_EQ(result.uncovered_fraction, 0.75); // a multiple of the grid of the rays
}

TEST(Verify, FindsAScanThatHangsOverATrimmedBaseMesh) {
    EXPECT_THAT(verify(square_without_kept_vertices({-1, 1}), grid(8, 0.25, 1.25, 0.5)), Has(Violation::no_preimage));
}

TEST(Verify, RefusesScanPointsOnAFreeBorder) {
    EXPECT_THAT(verify(square_without_kept_vertices({-1, 1}), grid(8, 0, 1, 0.5)), Has(Violation::border));
}

TEST(Verify, FindsAnInnerVertexBeyondTheBorder) {
    EXPECT_THAT(verify(square(), pyramid({0.4, 1.5, 0.3})),
                AllOf(Has(Violation::no_preimage), Has(Violation::orientation)));
}

TEST(Verify, FindsKeptVerticesThatAreNot) {
    BaseMesh base = square();
    base.positions[1].x() += 1e-15;
    EXPECT_THAT(verify(base, pyramid({0.4, 0.7, 0.3})), Has(Violation::kept_vertex));
    for (const std::int32_t wrong : {0, 7, -2}) { // kept twice, no vertex, no index
        base = square();
        base.scan_vertex[1] = wrong;
        EXPECT_THAT(verify(base, pyramid({0.4, 0.7, 0.3})), Has(Violation::kept_vertex));
    }
}

TEST(Verify, FindsAKeptVertexOutsideTheRange) {
    EXPECT_THAT(verify(square({0.1, 1}), pyramid({0.4, 0.7, 0.3})), Has(Violation::no_preimage));
}

TEST(Verify, FindsAMovingFaceWithoutItsLikeAcrossAKeptEdge) {
    BaseMesh base = square();
    base.faces.pop_back();
    base.ranges.pop_back();
    const Scan square_scan{base.positions, {{0, 2, 3}}};
    EXPECT_THAT(verify(base, square_scan), Has(Violation::border)); // one half each
    EXPECT_THAT(verify(base, Scan{base.positions, {{0, 1, 2}}}), IsCertified());
}

TEST(Verify, FreezesFacesThatAreScanFaces) {
    const Scan scan = pyramid({0.4, 0.7, 0.3});
    BaseMesh base = square();
    base.positions = scan.positions;
    base.directions.assign(5, {0, 0, 1});
    base.scan_vertex = {0, 1, 2, 3, 4};
    base.faces = scan.faces;
    base.ranges.assign(4, {0, 0});
    VerifyResult result = verify(base, scan);
    EXPECT_THAT(result, IsCertified());
    EXPECT_EQ(result.frozen_faces, 4);

    base.ranges[2] = {-0.5, 0.5}; // moves, over the scan face that it is
    result = verify(base, scan);
    EXPECT_THAT(result, IsCertified());
    EXPECT_EQ(result.frozen_faces, 3);

    base.directions[4] = {0, 0, -1}; // of no account on frozen faces alone
    EXPECT_THAT(verify(base, scan), Has(Violation::jacobian));
    base.ranges[2] = {0, 0};
    EXPECT_THAT(verify(base, scan), IsCertified());
}

TEST(Verify, ReportsVerticesThatOtherSheetsReachAsAmbiguous) {
    // Two squares, one 0.4 above the other, which does not see it: the tops are within the ranges of both.
    BaseMesh base = square();
    Scan scan = pyramid({0.4, 0.7, 0.3});
    for (int k = 0; k < 4; ++k) {
        base.positions.push_back(base.positions[k] + Vec3(0, 0, 0.4));
        base.scan_vertex.push_back(5 + k);
    }
    base.directions.assign(8, {0, 0, 1});
    base.faces.insert(base.faces.end(), {{4, 5, 6}, {4, 6, 7}});
    base.ranges.assign(4, {-1, 1});
    for (int k = 0; k < 5; ++k) {
        scan.positions.push_back(scan.positions[k] + Vec3(0, 0, 0.4));
    }
    scan.faces.insert(scan.faces.end(), {{5, 6, 9}, {6, 7, 9}, {7, 8, 9}, {8, 5, 9}});
    const VerifyResult result = verify(base, scan);
    EXPECT_THAT(result, IsCertified());
    EXPECT_EQ(result.ambiguous_vertices, 2);
    EXPECT_DOUBLE_EQ(result.max_displacement, 0.3); // each on its own sheet, though the other is nearer

    for (Range& range : base.ranges) {
        range = {-0.01, 0.31};
    }
    EXPECT_EQ(verify(base, scan).ambiguous_vertices, 0);
}

/// Five triangles around a vertex that turn `laps` times around it at t = 1, and once at t = 0.
BaseMesh pentagon(int laps) {
    BaseMesh base;
    base.positions.emplace_back(0, 0, 0);
    base.directions.emplace_back(0, 0, 1);
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * std::numbers::pi * k / 5;
        const Vec3 here(std::cos(angle), std::sin(angle), 0);
        base.positions.push_back(here);
        base.directions.emplace_back(Vec3(std::cos(laps * angle), std::sin(laps * angle), 1) - here);
        base.faces.push_back({0, 1 + k, 1 + (k + 1) % 5});
    }
    base.ranges.assign(5, {0.95, 1.05});
    return base;
}

TEST(Verify, FindsTwoPlacesInFacesThatShareAVertex) {
    const Scan scan{{{0.1, 0.02, 1}, {-0.05, 0.1, 1}, {-0.04, -0.1, 1}}, {{0, 1, 2}}};
    EXPECT_THAT(verify(pentagon(1), scan), IsCertified());
    const VerifyResult twice = verify(pentagon(2), scan);
    EXPECT_EQ(count(twice, Violation::several_preimages), 3);
    EXPECT_GT(count(twice, Violation::jacobian), 0); // the prismoids go round the pillar twice
}

TEST(VerifyFaceDirections, CertifiesAScanOverOneFace) {
    BaseMesh base = square();
    base.directions.clear();
    base.faces.pop_back();
    base.ranges.pop_back();
    base.face_directions = {{0, 0, 1}};
    Scan scan{base.positions, {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}}};
    scan.positions.emplace_back(0.6, 0.3, 0.2);
    EXPECT_THAT(verify(base, scan), IsCertified());
    scan.positions.back() = {0.6, 0.8, 0.2}; // beyond the border
    EXPECT_THAT(verify(base, scan), Has(Violation::no_preimage));
}

TEST(VerifyFaceDirections, FindsAnEdgeWithoutACommonFace) {
    BaseMesh base = square();
    base.directions.clear();
    base.face_directions.assign(2, {0, 0, 1});
    EXPECT_THAT(verify(base, pyramid({0.7, 0.3, 0.2})), Has(Violation::trace));
    EXPECT_THAT(verify(base, pyramid({0.5, 0.5, 0})), IsCertified()); // on the edge that the faces share
}

TEST(VerifyFaceDirections, FindsInteriorPointsInNoFace) {
    // The scan is the foot of a pyramid without foot: its edges are base edges, its inside is far from the sides.
    const Scan scan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    BaseMesh base;
    base.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.5}};
    base.scan_vertex = {0, 1, 2, -1};
    base.faces = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const auto& [a, b, c] : base.faces) {
        base.face_directions.push_back(
            (base.positions[b] - base.positions[a]).cross(base.positions[c] - base.positions[a]).normalized());
    }
    base.ranges.assign(3, {-0.01, 0.01});
    EXPECT_THAT(verify(base, scan), Has(Violation::interior_sample));
}

} // namespace
} // namespace foldless
