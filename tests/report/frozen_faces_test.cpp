#include <foldless/report/frozen_faces.h>

#include <gtest/gtest.h>

namespace foldless {

namespace {

// Scan vertices 0 to 3; base vertices are the scan vertices 1, 2, 3, 0, in this order.
Scan two_triangles() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

BaseMesh the_same_renumbered() {
    BaseMesh base;
    base.positions = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
    base.scan_vertex = {1, 2, 3, 0};
    base.faces = {{0, 1, 3}, {2, 3, 1}};
    base.ranges = {{0.0, 0.0}, {0.0, 0.0}};
    return base;
}

TEST(CountFrozenFaces, CountsScanFacesWithAnyFirstCorner) {
    EXPECT_EQ(count_frozen_faces(the_same_renumbered(), two_triangles()), 2u);
}

TEST(CountFrozenFaces, LeavesOutAFaceWithARange) {
    BaseMesh base = the_same_renumbered();
    base.ranges[0] = {0.0, 0.5};
    EXPECT_EQ(count_frozen_faces(base, two_triangles()), 1u);
}

TEST(CountFrozenFaces, LeavesOutAFaceWithAMovedCorner) {
    BaseMesh base = the_same_renumbered();
    base.scan_vertex[0] = -1;
    EXPECT_EQ(count_frozen_faces(base, two_triangles()), 1u);
}

TEST(CountFrozenFaces, LeavesOutKeptCornersThatAreNoScanFace) {
    BaseMesh base = the_same_renumbered();
    base.faces = {{0, 1, 2}};
    base.ranges = {{0.0, 0.0}};
    EXPECT_EQ(count_frozen_faces(base, two_triangles()), 0u);
}

TEST(CountFrozenFaces, LeavesOutAScanFaceThatIsTurnedOver) {
    BaseMesh base = the_same_renumbered();
    base.faces[0] = {1, 0, 3};
    EXPECT_EQ(count_frozen_faces(base, two_triangles()), 1u);
}

TEST(CountFrozenFaces, FindsNoneWithoutRangesOrScanVertices) {
    BaseMesh base = the_same_renumbered();
    base.ranges.clear();
    EXPECT_EQ(count_frozen_faces(base, two_triangles()), 0u);
    base = the_same_renumbered();
    base.scan_vertex.clear();
    EXPECT_EQ(count_frozen_faces(base, two_triangles()), 0u);
}

} // namespace

} // namespace foldless
