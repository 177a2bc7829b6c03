#include "manifold_check.h"
#include "meshes.h"

#include <foldless/io/defects.h>
#include <foldless/repair/continuations.h>

#include <gtest/gtest.h>

namespace foldless::test {
namespace {

/// The faces of a tetrahedron on four vertices.
std::vector<Triangle> tetrahedron_on(const std::array<std::int32_t, 4>& vertices) {
    std::vector<Triangle> faces = tetrahedron;
    for (Triangle& face : faces) {
        for (std::int32_t& vertex : face) {
            vertex = vertices[vertex];
        }
    }
    return faces;
}

/// A flat square 0 1 2 3 in two faces with a fin over its diagonal from 0 to 2.
Scan square_with_fin(bool fin_forward) {
    Scan scan;
    scan.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    scan.faces = {{0, 1, 2}, {0, 2, 3}, fin_forward ? Triangle{0, 2, 4} : Triangle{2, 0, 4}};
    return scan;
}

TEST(Repair, GivesEachFanOfABowTieItsVertex) {
    const RepairResult result = repaired({{0, 1, 2}, {0, 3, 4}});
    EXPECT_EQ(result.counts.text(), "1 vertex split, 1 vertex added");
    EXPECT_EQ(result.scan.faces, (std::vector<Triangle>{{0, 1, 2}, {5, 3, 4}}));
    EXPECT_EQ(result.scan.positions[5], result.scan.positions[0]);
    EXPECT_EQ(repaired({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}).counts.text(), "") << "one fan";
}

TEST(Repair, SplitsAVertexOfThreeFansIntoThree) {
    const RepairResult result = repaired({{0, 1, 2}, {3, 4, 0}, {5, 0, 6}});
    EXPECT_EQ(result.counts.text(), "1 vertex split, 2 vertices added");
    EXPECT_EQ(result.scan.faces, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 7}, {5, 8, 6}}));
}

TEST(Repair, SeparatesTetrahedraThatShareAVertex) {
    const RepairResult result = repaired(joined(tetrahedron, tetrahedron_on({0, 4, 5, 6})));
    EXPECT_EQ(result.counts.text(), "1 vertex split, 1 vertex added");
    EXPECT_EQ(inspect(result.scan).topology.components, 2U);
    EXPECT_EQ(inspect(result.scan).topology.boundary_edges, 0U) << "both stay closed";
}

TEST(Repair, SeparatesTetrahedraThatShareAnEdge) {
    const RepairResult result = repaired(joined(tetrahedron, tetrahedron_on({0, 1, 4, 5})));
    EXPECT_EQ(result.counts.text(), "1 non-manifold edge taken apart, 2 vertices split, 2 vertices added");
    EXPECT_EQ(inspect(result.scan).topology.components, 2U);
    EXPECT_EQ(inspect(result.scan).topology.boundary_edges, 0U) << "both stay closed";
}

TEST(Repair, TakesAFinOffTheSurfaceThatGoesOn) {
    for (const bool forward : {false, true}) {
        const RepairResult result = repair(square_with_fin(forward));
        EXPECT_EQ(result.counts.text(), "1 non-manifold edge taken apart, 2 vertices split, 2 vertices added");
        EXPECT_EQ(result.scan.faces[0], (Triangle{0, 1, 2}));
        EXPECT_EQ(result.scan.faces[1], (Triangle{0, 2, 3})) << "the square keeps its diagonal";
        EXPECT_EQ(result.scan.faces[2], (Triangle{5, 6, 4}));
    }
}

TEST(Repair, KeepsASquareWithoutAFin) {
    Scan scan = square_with_fin(true);
    scan.faces.pop_back();
    scan.positions.pop_back();
    EXPECT_EQ(repair(scan).counts.text(), "");
}

TEST(Repair, TakesApartAnEdgeOfThreeFacesInOneDirection) {
    const RepairResult result = repaired({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    EXPECT_EQ(result.counts.text(), "1 non-manifold edge taken apart, 2 vertices split, 4 vertices added");
    EXPECT_EQ(inspect(result.scan).topology.components, 3U);
}

// Two sheets that cross along an edge: each goes on on its other side.
TEST(Repair, TakesCrossingSheetsApart) {
    Scan scan;
    scan.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    scan.faces = {{0, 1, 2}, {1, 0, 4}, {1, 0, 3}, {0, 1, 5}};
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "1 non-manifold edge taken apart, 2 vertices split, 2 vertices added");
    EXPECT_EQ(result.scan.faces, (std::vector<Triangle>{{0, 1, 2}, {6, 7, 4}, {1, 0, 3}, {7, 6, 5}}));
}

// The faces around 0 and those around 1 make one surface that comes by the edge 0 1 twice: no pair may stay together
// there, or the edge would have four faces still.
TEST(Repair, GivesAPairUpThatWouldLeaveAnEdgeOfFourFaces) {
    const std::vector<Triangle> first = tetrahedron_on({0, 1, 2, 3});
    const std::vector<Triangle> second = inside_out(tetrahedron_on({0, 1, 4, 5}));
    Scan scan = mesh(joined(first, second));
    // Bent so that the faces across, of two tetrahedra, are closest.
    scan.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0.1, 0}, {1, -0.1, 0}, {-1, -0.1, 0}, {-1, 0.1, 0}};
    const RepairResult result = repair(scan);
    EXPECT_EQ(flaw_of(result.scan), "");
    EXPECT_EQ(inspect(result.scan).topology.boundary_edges, 0U);
    EXPECT_EQ(inspect(result.scan).topology.components, 2U);
}

TEST(Repair, TakesTheFacesOfACrowdedEdgeApart) {
    std::vector<Triangle> faces;
    for (std::int32_t i = 0; i < 12; ++i) {
        faces.push_back(i % 2 == 0 ? Triangle{0, 1, 2 + i} : Triangle{1, 0, 2 + i});
    }
    ASSERT_GT(faces.size(), most_faces_continued);
    const RepairResult result = repaired(faces);
    EXPECT_EQ(flaw_of(result.scan), "");
    EXPECT_EQ(inspect(result.scan).topology.components, faces.size());
}

TEST(Repair, CountsVerticesAndFacesThatAreLeft) {
    const RepairResult result =
        repaired(joined(joined(tetrahedron, tetrahedron_on({0, 1, 5, 6})), {{8, 8, 9}, {0, 2, 1}, {2, 11, 12}}));
    const RepairCounts& counts = result.counts;
    EXPECT_EQ(result.scan.positions.size(), 13 + counts.added_vertices - counts.dropped_vertices);
    EXPECT_EQ(result.scan.faces.size(), 11 - counts.repeated_index_faces - counts.duplicate_faces);
}

} // namespace
} // namespace foldless::test
