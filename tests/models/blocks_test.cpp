#include <foldless/models/blocks.h>

#include "mesh_check.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

Scan mesh_of(const BlockSurface& surface, std::int64_t n) {
    const Quilt quilt(surface.patches, n);
    Scan scan;
    for (std::int64_t vertex = 0; vertex < quilt.vertices(); ++vertex) {
        scan.positions.push_back(surface.point(quilt.place(vertex)));
    }
    for (std::int64_t face = 0; face < quilt.faces(); ++face) {
        scan.faces.push_back(quilt.triangle(face));
    }
    return scan;
}

TEST(Blocks, OneBoxIsClosedAndFacesOutward) {
    const BlockSurface surface = surface_of({{{{{0, 2}, {1}}, {{0, 3}, {2}}, {{0, 5}, {3}}}}, {{0, 0, 0}}});
    EXPECT_EQ(surface.patches.size(), 6U);
    EXPECT_EQ(surface.corners.size(), 8U);
    const MeshCheck check = check_mesh(mesh_of(surface, 2));
    EXPECT_EQ(check.repeated_half_edges, 0U);
    EXPECT_EQ(check.boundary_edges, 0U);
    EXPECT_EQ(check.euler_characteristic, 2);
    EXPECT_DOUBLE_EQ(check.volume, 30);
}

TEST(Blocks, NeighboursHaveNoWallBetweenThem) {
    const BlockAxis one{{0, 1}, {1}};
    const BlockSurface surface = surface_of({{{{{0, 1, 3}, {1, 2}}, one, one}}, {{0, 0, 0}, {1, 0, 0}}});
    EXPECT_EQ(surface.patches.size(), 10U);
    const MeshCheck check = check_mesh(mesh_of(surface, 1));
    EXPECT_EQ(check.repeated_half_edges, 0U);
    EXPECT_DOUBLE_EQ(check.volume, 3);
}

TEST(Blocks, NumberCornersByHeightFirst) {
    const BlockAxis one{{0, 1}, {1}};
    const BlockSurface surface = surface_of({{{one, one, one}}, {{0, 0, 0}}});
    EXPECT_EQ(surface.corners[1], Vec3(1, 0, 0));
    EXPECT_EQ(surface.corners[2], Vec3(0, 1, 0));
    EXPECT_EQ(surface.corners[4], Vec3(0, 0, 1));
}

} // namespace
} // namespace foldless
