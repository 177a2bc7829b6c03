#include "manifold_check.h"
#include "meshes.h"

#include <foldless/io/defects.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace foldless::test {
namespace {

Scan random_soup(std::mt19937& random) {
    const auto vertices = static_cast<std::int32_t>(3 + random() % 12);
    const auto below = [&](std::int32_t n) { return static_cast<std::int32_t>(random() % static_cast<unsigned>(n)); };
    Scan scan;
    for (std::int32_t i = 0; i < vertices; ++i) {
        // Few places, so that faces without area are frequent.
        scan.positions.emplace_back(below(4), below(4), below(3));
    }
    const std::size_t faces = 1 + random() % 40;
    while (scan.faces.size() < faces) {
        scan.faces.push_back({below(vertices), below(vertices), below(vertices)});
    }
    return scan;
}

ScanTriangle corners(const Scan& scan, const Triangle& face) {
    return {scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
}

/// The faces that a repair has to keep, from the definition.
std::vector<ScanTriangle> faces_to_keep(const Scan& scan) {
    std::vector<ScanTriangle> kept;
    std::set<std::set<std::int32_t>> seen;
    for (const Triangle& face : scan.faces) {
        const std::set<std::int32_t> vertices(face.begin(), face.end());
        const ScanTriangle triangle = corners(scan, face);
        const bool flat = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]) == Vec3::Zero();
        if (vertices.size() == 3 && !flat && seen.insert(vertices).second) {
            kept.push_back(triangle);
        }
    }
    return kept;
}

/// Checks that the faces are those to keep, in their order, some turned over. Returns how many.
std::size_t turned_over(const Scan& scan, const std::vector<ScanTriangle>& wanted) {
    std::size_t turned = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const ScanTriangle found = corners(scan, scan.faces[i]);
        const ScanTriangle back{wanted[i][0], wanted[i][2], wanted[i][1]};
        EXPECT_TRUE(found == wanted[i] || found == back);
        turned += found == wanted[i] ? 0 : 1;
    }
    return turned;
}

void expect_sound_repair(const Scan& soup) {
    const std::vector<ScanTriangle> wanted = faces_to_keep(soup);
    if (wanted.empty()) {
        EXPECT_THROW((void)repair(soup), RefusedMesh);
        return;
    }
    const auto [scan, counts] = repair(soup);
    EXPECT_EQ(flaw_of(scan), "");
    EXPECT_EQ(inspect(scan).defects.text(), "");
    ASSERT_EQ(scan.faces.size(), wanted.size());
    EXPECT_EQ(turned_over(scan, wanted), counts.turned_faces);
    EXPECT_EQ(scan.positions.size(), soup.positions.size() + counts.added_vertices - counts.dropped_vertices);
    const RepairResult again = repair(scan);
    EXPECT_EQ(again.counts.text(), "");
    EXPECT_EQ(again.scan.faces, scan.faces);
    EXPECT_EQ(again.scan.positions, scan.positions);
}

TEST(RepairOfSoups, LeavesNoDefectAndNothingMoreToRepair) {
    std::mt19937 random(1);
    for (int round = 0; round < 5000; ++round) {
        SCOPED_TRACE(round);
        expect_sound_repair(random_soup(random));
        ASSERT_FALSE(testing::Test::HasFailure());
    }
}

TEST(RepairOfSoups, LeavesNoDefectUnderAllOptions) {
    std::mt19937 random(2);
    int left = 0;
    for (int round = 0; round < 3000; ++round) {
        SCOPED_TRACE(round);
        RepairOptions options;
        options.drop_unserved = true;
        options.min_component_faces = 1 + random() % 4;
        try {
            const auto [scan, counts] = repair(random_soup(random), options);
            EXPECT_EQ(flaw_of(scan), "");
            EXPECT_EQ(repair(scan, options).counts.text(), "");
            ++left;
        } catch (const RefusedMesh&) {
            continue; // no face is left
        }
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    EXPECT_GT(left, 1000);
}

// Every soup of three faces on five vertices, of which the first face is fixed.
TEST(RepairOfSoups, LeavesNoDefectInAnyMeshOfThreeFaces) {
    std::vector<Triangle> faces;
    for (std::int32_t a = 0; a < 5; ++a) {
        for (std::int32_t b = 0; b < 5; ++b) {
            for (std::int32_t c = 0; c < 5; ++c) {
                faces.push_back({a, b, c});
            }
        }
    }
    Scan scan = mesh({{0, 1, 2}, {0, 1, 4}});
    for (const Triangle& second : faces) {
        for (const Triangle& third : faces) {
            scan.faces = {{0, 1, 2}, second, third};
            expect_sound_repair(scan);
        }
        ASSERT_FALSE(testing::Test::HasFailure());
    }
}

} // namespace
} // namespace foldless::test
