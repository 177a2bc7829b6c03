#include "manifold_check.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace foldless::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Repair, LeavesACleanScanAsItIs) {
    Scan scan = mesh(tetrahedron);
    scan.positions[0] = {-0.0, 0.1, 0.3};
    scan.float32 = false;
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "");
    EXPECT_FALSE(result.counts.any());
    EXPECT_EQ(result.scan.faces, scan.faces);
    EXPECT_EQ(result.scan.positions, scan.positions);
    EXPECT_TRUE(std::signbit(result.scan.positions[0].x())) << "positions keep their bits";
    EXPECT_FALSE(result.scan.float32);
}

TEST(Repair, DropsFacesWithARepeatedIndex) {
    const RepairResult result = repaired(joined(tetrahedron, {{0, 1, 1}, {2, 3, 2}, {3, 3, 3}}));
    EXPECT_EQ(result.counts.text(), "3 faces with a repeated index dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
}

TEST(Repair, DropsFacesWithAnIndexOutOfRange) {
    Scan scan = mesh(tetrahedron);
    scan.faces.push_back({0, 1, 4});
    scan.faces.push_back({-1, 1, 2});
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "2 faces with an index out of range dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
}

TEST(Repair, DropsFacesOnOneLine) {
    Scan scan = mesh({{0, 1, 2}, {3, 4, 5}});
    scan.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}};
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "1 zero-area face dropped, 3 unused vertices dropped");
    EXPECT_EQ(result.scan.faces, (std::vector<Triangle>{{0, 1, 2}}));
    scan.positions[5].x() = std::nextafter(0.3, 1.0);
    EXPECT_EQ(repair(scan).counts.text(), "") << "a sliver of some area stays";
}

TEST(Repair, DropsFacesWithTwoCornersAtOnePlace) {
    Scan scan = mesh(joined(tetrahedron, {{0, 1, 4}}));
    scan.positions[4] = scan.positions[1];
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "1 zero-area face dropped, 1 unused vertex dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
}

TEST(Repair, DropsFacesWithCornersThatAreNotFinite) {
    Scan scan = mesh(joined(tetrahedron, {{0, 4, 1}, {4, 5, 6}}));
    scan.positions[4].y() = nan;
    scan.positions[5].x() = -std::numeric_limits<double>::infinity();
    scan.float32 = false; // a NaN is none
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "2 faces with a corner that is not finite dropped, 3 unused vertices dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
    EXPECT_TRUE(result.scan.float32) << "what is left are float32 values";
}

TEST(Repair, DropsUnusedVerticesThoughTheyAreNotFinite) {
    Scan scan = mesh(raised(tetrahedron, 2));
    scan.positions[1].z() = nan;
    scan.positions.emplace_back(7, 7, 7);
    const RepairResult result = repair(scan);
    EXPECT_EQ(result.counts.text(), "3 unused vertices dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
    EXPECT_EQ(result.scan.positions, (std::vector<Vec3>(scan.positions.begin() + 2, scan.positions.end() - 1)));
}

TEST(Repair, DropsDuplicateFacesOfTheSameOrientation) {
    const RepairResult result = repaired(joined(tetrahedron, {{2, 1, 0}, {0, 1, 3}}));
    EXPECT_EQ(result.counts.text(), "2 duplicate faces dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
}

TEST(Repair, DropsDuplicateFacesOfOppositeOrientation) {
    const RepairResult result = repaired(joined(tetrahedron, {{0, 1, 2}}));
    EXPECT_EQ(result.counts.text(), "1 duplicate face dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
}

// The duplicate that stays is the first, which is then the one face that is turned over.
TEST(Repair, KeepsTheFirstOfTwoDuplicatesAndTurnsItIfNeedBe) {
    const RepairResult result = repaired(joined({{1, 2, 0}}, tetrahedron));
    EXPECT_EQ(result.counts.text(), "1 duplicate face dropped, 1 face turned over");
    EXPECT_EQ(result.scan.faces, (std::vector<Triangle>{{1, 0, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
}

TEST(Repair, KeepsFacesThatShareTwoVerticesOnly) {
    EXPECT_EQ(repaired({{0, 1, 2}, {1, 0, 3}}).counts.text(), "");
}

// A fin of two triangles stands on the edge 0 1 of a closed surface, each written for both of its sides.
TEST(Repair, DropsAFinThatStandsOnAClosedSurface) {
    const std::vector<Triangle> fin{{0, 1, 4}, {1, 5, 4}};
    const RepairResult result = repaired(joined(joined(fin, tetrahedron), inside_out(fin)));
    EXPECT_EQ(result.counts.text(),
              "2 duplicate faces dropped, 2 faces of walls of no thickness dropped, 2 unused vertices dropped");
    EXPECT_EQ(result.scan.faces, tetrahedron);
}

TEST(Repair, KeepsOneSideOfASheetThatGoesOnFromABorder) {
    const std::vector<Triangle> sheet{{1, 0, 3}, {1, 3, 4}};
    const RepairResult result = repaired(joined(joined({{0, 1, 2}}, sheet), inside_out(sheet)));
    EXPECT_EQ(result.counts.text(), "2 duplicate faces dropped");
    EXPECT_EQ(result.scan.faces, joined({{0, 1, 2}}, sheet));
}

TEST(Repair, KeepsOneSideOfASheetThatStandsAlone) {
    const std::vector<Triangle> sheet{{0, 1, 2}, {1, 3, 2}};
    const RepairResult result = repaired(joined(joined(sheet, inside_out(sheet)), raised(tetrahedron, 4)));
    EXPECT_EQ(result.counts.text(), "2 duplicate faces dropped");
    EXPECT_EQ(result.scan.faces, joined(sheet, raised(tetrahedron, 4)));
}

// Two tetrahedra in contact at the face 0 1 2, which both have: one surface without it.
TEST(Repair, DropsTheWallBetweenTwoPartsInContact) {
    const std::vector<Triangle> other{{0, 1, 2}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
    const RepairResult result = repaired(joined(tetrahedron, other));
    EXPECT_EQ(result.counts.text(), "1 duplicate face dropped, 1 face of a wall of no thickness dropped");
    EXPECT_EQ(result.scan.faces,
              (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}));
    EXPECT_EQ(flaw_of(result.scan), "");
}

// Three copies are one face of the surface and a wall of no thickness on it.
TEST(Repair, KeepsOneOfThreeCopies) {
    EXPECT_EQ(repaired(joined(tetrahedron, {{0, 1, 2}, {2, 1, 0}})).scan.faces, tetrahedron);
}

TEST(Repair, RefusesAMeshOfWhichNothingIsLeft) {
    const auto message_of = [](const Scan& scan) -> std::string {
        try {
            (void)repair(scan);
        } catch (const RefusedMesh& refusal) {
            return refusal.what();
        }
        return "no refusal";
    };
    EXPECT_EQ(message_of({}), "no faces");
    EXPECT_EQ(message_of({{{0, 0, 0}, {1, 0, 0}}, {}}), "no faces");
    EXPECT_EQ(message_of(mesh({{0, 1, 1}})),
              "no face is left by the repair: 1 face with a repeated index dropped, 2 unused vertices dropped");
}

} // namespace
} // namespace foldless::test
