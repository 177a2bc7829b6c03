#include "manifold_check.h"
#include "meshes.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/defects.h>

#include <gtest/gtest.h>

namespace foldless::test {
namespace {

RepairResult without_small(const std::vector<Triangle>& faces, std::size_t least) {
    RepairOptions options;
    options.min_component_faces = least;
    return repair(mesh(faces), options);
}

TEST(RepairSmallComponents, AreDroppedBelowTheBoundOnly) {
    const std::vector<Triangle> faces = joined(tetrahedron, {{4, 5, 6}, {5, 4, 7}, {8, 9, 10}});
    EXPECT_EQ(without_small(faces, 1).counts.text(), "");
    EXPECT_EQ(without_small(faces, 2).counts.text(),
              "1 small component dropped, 1 face of small components dropped, 3 unused vertices dropped");
    EXPECT_EQ(without_small(faces, 3).counts.text(),
              "2 small components dropped, 3 faces of small components dropped, 7 unused vertices dropped");
    EXPECT_EQ(without_small(faces, 4).scan.faces, tetrahedron);
    EXPECT_THROW((void)without_small(faces, 5), RefusedMesh);
}

// What hangs together by a vertex that a repair splits is two components.
TEST(RepairSmallComponents, AreThoseAfterTheSplit) {
    const RepairResult result = without_small(joined(tetrahedron, {{3, 4, 5}}), 2);
    EXPECT_EQ(result.scan.faces, tetrahedron);
    EXPECT_EQ(result.counts.small_components, 1U);
}

/// A fan of six faces around 0, of which one looks along z and one against it: no direction sees both. Two more faces
/// beside it meet in vertex 2.
Scan spike() {
    Scan scan;
    scan.positions = {{0, 0, 0},    {2, 0, 0},  {0, 2, 0}, {-1, 0, 1}, {0.25, 1, 0},
                      {1, 0.25, 0}, {1, -1, 2}, {2, 2, 0}, {-1, 2, 1}};
    scan.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}, {2, 1, 7}, {3, 2, 8}};
    return scan;
}

TEST(RepairUnserved, StaysUnlessItIsAskedFor) {
    ASSERT_EQ(inspect(spike()).defects.text(), "");
    EXPECT_EQ(repair(spike()).counts.text(), "");
}

TEST(RepairUnserved, GoesWithItsFacesAndTheBowTieThatThisLeaves) {
    RepairOptions options;
    options.drop_unserved = true;
    const RepairResult result = repair(spike(), options);
    EXPECT_EQ(result.counts.text(), "1 vertex split, 1 vertex added, 1 unserved vertex removed, "
                                    "6 faces around unserved vertices dropped, 4 unused vertices dropped");
    EXPECT_EQ(result.scan.faces, (std::vector<Triangle>{{1, 0, 3}, {2, 5, 4}}));
    EXPECT_EQ(flaw_of(result.scan), "");
}

TEST(RepairUnserved, IsWhatTheDecimatorCountsAsSuch) {
    EXPECT_EQ(decimate(spike()).statistics.unserved_vertices, 1U);
    RepairOptions options;
    options.drop_unserved = true;
    EXPECT_EQ(decimate(repair(spike(), options).scan).statistics.unserved_vertices, 0U);
}

TEST(RepairUnserved, LeavesWhatIsServed) {
    RepairOptions options;
    options.drop_unserved = true;
    EXPECT_EQ(repair(mesh(tetrahedron), options).counts.text(), "");
}

} // namespace
} // namespace foldless::test
