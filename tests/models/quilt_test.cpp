#include <foldless/models/quilt.h>

#include "mesh_check.h"

#include <gtest/gtest.h>

#include <vector>

namespace foldless {
namespace {

/// The whole connectivity, with positions that do not matter.
Scan connectivity(const Quilt& quilt) {
    Scan scan;
    for (std::int64_t vertex = 0; vertex < quilt.vertices(); ++vertex) {
        const SurfacePlace place = quilt.place(vertex);
        scan.positions.emplace_back(place.patch + place.u, place.v, 0);
    }
    for (std::int64_t face = 0; face < quilt.faces(); ++face) {
        scan.faces.push_back(quilt.triangle(face));
    }
    return scan;
}

TEST(Quilt, SharesAnEdgeWhoseSidesRunAgainstEachOther) {
    // QuiltPatch 0 has the edge 1-2 as its right side; the second patch is turned by half a turn, so that the same edge
    // is its right side too, running the other way.
    const std::vector<QuiltPatch> patches = {{{0, 1, 2, 3}}, {{4, 2, 1, 5}}};
    const MeshCheck check = check_mesh(connectivity(Quilt(patches, 4)));
    EXPECT_EQ(check.repeated_half_edges, 0U);
    EXPECT_EQ(check.components, 1U);
    EXPECT_EQ(check.boundary_edges, 24U);
    EXPECT_EQ(check.euler_characteristic, 1);
}

TEST(Quilt, AcceptsEveryTurnOfAPatch) {
    const std::vector<int> ring = {1, 5, 4, 2}; // beside the edge 1-2
    for (int turn = 0; turn < 4; ++turn) {
        QuiltPatch second{};
        for (int i = 0; i < 4; ++i) {
            second.corners[i] = ring[(i + turn) % 4];
        }
        const MeshCheck check = check_mesh(connectivity(Quilt({{{0, 1, 2, 3}}, second}, 3)));
        EXPECT_EQ(check.repeated_half_edges, 0U) << turn;
        EXPECT_EQ(check.boundary_loops, 1U) << turn;
        EXPECT_EQ(check.boundary_edges, 18U) << turn;
        EXPECT_EQ(check.unused_vertices, 0U) << turn;
        EXPECT_EQ(check.euler_characteristic, 1) << turn;
    }
}

TEST(Quilt, KeepsCornersFirstAtEverySize) {
    for (const std::int64_t n : {1, 2, 5}) {
        const Quilt quilt({{{0, 1, 2, 3}, 2, 3}}, n);
        EXPECT_EQ(quilt.vertices(), (2 * n + 1) * (3 * n + 1));
        EXPECT_EQ(quilt.faces(), 12 * n * n);
        EXPECT_EQ(quilt.place(2).u, 1);
        EXPECT_EQ(quilt.place(2).v, 1);
        EXPECT_EQ(quilt.triangle(0)[0], 0);
    }
}

TEST(Quilt, GivesEachVertexOfAPatchItsOwnPlace) {
    const Quilt quilt({{{0, 1, 2, 3}, 2, 1}, {{1, 4, 5, 2}, 1, 1}}, 3);
    EXPECT_EQ(check_mesh(connectivity(quilt)).equal_positions, 0U);
    // In the plane (patch + u, v) no triangle is flipped or empty.
    const Scan scan = connectivity(quilt);
    for (const auto& [a, b, c] : scan.faces) {
        const Vec3 normal = (scan.positions[b] - scan.positions[a]).cross(scan.positions[c] - scan.positions[a]);
        EXPECT_GT(normal.z(), 0);
    }
}

} // namespace
} // namespace foldless
