#include "manifold_check.h"
#include "meshes.h"

#include <foldless/io/defects.h>

#include <gtest/gtest.h>

#include <random>

namespace foldless::test {
namespace {

/// A strip of quads in a ring, each cut in two: 2 columns faces. With a half turn it is a Moebius strip.
std::vector<Triangle> ring(std::int32_t columns, bool half_turn) {
    std::vector<Triangle> faces;
    for (std::int32_t i = 0; i < columns; ++i) {
        const bool last = i + 1 == columns;
        const std::int32_t low = last ? (half_turn ? 1 : 0) : 2 * i + 2;
        const std::int32_t high = last ? (half_turn ? 0 : 1) : 2 * i + 3;
        faces.push_back({2 * i, low, high});
        faces.push_back({2 * i, high, 2 * i + 1});
    }
    return faces;
}

/// A grid of squares whose opposite sides are one, one pair of them after reversal: a Klein bottle. With `straight` no
/// reversal: a torus.
std::vector<Triangle> closed_grid(std::int32_t size, bool straight) {
    const auto vertex = [=](std::int32_t row, std::int32_t column) {
        const bool beyond = row == size;
        const std::int32_t reversed = straight ? column : (size - column) % size;
        return beyond ? (reversed % size) : row * size + column % size;
    };
    std::vector<Triangle> faces;
    for (std::int32_t row = 0; row < size; ++row) {
        for (std::int32_t column = 0; column < size; ++column) {
            const std::int32_t a = vertex(row, column);
            const std::int32_t b = vertex(row, column + 1);
            const std::int32_t c = vertex(row + 1, column + 1);
            const std::int32_t d = vertex(row + 1, column);
            faces.push_back({a, b, c});
            faces.push_back({a, c, d});
        }
    }
    return faces;
}

TEST(Repair, TurnsOverAFaceThatDisagrees) {
    std::vector<Triangle> faces = tetrahedron;
    std::swap(faces[2][0], faces[2][1]);
    const RepairResult result = repaired(faces);
    EXPECT_EQ(result.counts.text(), "1 face turned over");
    EXPECT_EQ(result.scan.faces[2], (Triangle{2, 3, 1})) << "the first corner stays the first";
    faces[2] = result.scan.faces[2];
    EXPECT_EQ(result.scan.faces, faces) << "all others are untouched";
}

TEST(Repair, LeavesTheFirstFaceWhereBothWaysTurnAsMany) {
    EXPECT_EQ(repaired({{0, 1, 2}, {0, 1, 3}}).scan.faces, (std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}}));
}

TEST(Repair, TurnsTheFewerFacesThoughTheFirstIsAmongThem) {
    std::vector<Triangle> faces = tetrahedron;
    std::swap(faces[0][1], faces[0][2]);
    EXPECT_EQ(repaired(faces).counts.text(), "1 face turned over");
    EXPECT_EQ(repaired(faces).scan.faces, tetrahedron);
}

// Which side is the outside is not asked: a part that agrees is what its author meant.
TEST(Repair, LeavesAComponentThatIsInsideOut) {
    const std::vector<Triangle> faces = joined(tetrahedron, raised(inside_out(tetrahedron), 4));
    const RepairResult result = repaired(faces);
    EXPECT_EQ(result.counts.text(), "");
    EXPECT_EQ(result.scan.faces, faces);
}

TEST(Repair, OrientsEachComponentByItself) {
    std::vector<Triangle> faces = joined(tetrahedron, raised(inside_out(tetrahedron), 4));
    std::swap(faces[1][1], faces[1][2]);
    std::swap(faces[6][1], faces[6][2]);
    const RepairResult result = repaired(faces);
    EXPECT_EQ(result.counts.text(), "2 faces turned over");
    EXPECT_EQ(result.scan.faces, joined(tetrahedron, raised(inside_out(tetrahedron), 4)));
}

TEST(Repair, CutsAMoebiusStripWhereItDisagrees) {
    const RepairResult result = repaired(ring(5, true));
    EXPECT_EQ(result.counts.text(), "1 edge cut open for want of an orientation, 2 vertices split, 2 vertices added");
    const Inspection found = inspect(result.scan);
    EXPECT_EQ(found.defects.text(), "");
    EXPECT_EQ(found.topology.components, 1U);
    EXPECT_EQ(found.topology.boundary_loops, 1U);
    EXPECT_EQ(found.topology.euler_characteristic, 1) << "a disk";
    EXPECT_EQ(repaired(ring(5, false)).counts.text(), "") << "without the half turn there is nothing to cut";
}

TEST(Repair, CutsAKleinBottleAlongItsSeam) {
    const RepairResult result = repaired(closed_grid(5, false));
    EXPECT_EQ(result.counts.text(), "5 edges cut open for want of an orientation, 5 vertices split, 5 vertices added");
    const Inspection found = inspect(result.scan);
    EXPECT_EQ(found.defects.text(), "");
    EXPECT_EQ(found.topology.components, 1U);
    EXPECT_EQ(found.topology.euler_characteristic, 0);
    EXPECT_EQ(found.topology.boundary_loops, 2U) << "an annulus";
    EXPECT_EQ(flaw_of(result.scan), "");
    EXPECT_EQ(repaired(closed_grid(5, true)).counts.text(), "") << "a torus";
}

// The cut must close up around the hole of the surface whatever the orientations that the file gives.
TEST(Repair, CutsOneSidedSurfacesWhoseFacesAreTurnedAtRandom) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<Triangle> faces = round % 2 == 0 ? ring(4 + round % 7, true) : closed_grid(4 + round % 4, false);
        for (Triangle& face : faces) {
            if (random() % 2 == 0) {
                std::swap(face[0], face[1]);
            }
        }
        const RepairResult result = repaired(faces);
        EXPECT_EQ(flaw_of(result.scan), "");
        EXPECT_GT(result.counts.unorientable_edges, 0U);
        EXPECT_EQ(result.scan.faces.size(), faces.size());
        EXPECT_EQ(inspect(result.scan).topology.components, 1U);
    }
}

} // namespace
} // namespace foldless::test
