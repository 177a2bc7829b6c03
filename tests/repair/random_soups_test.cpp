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

struct Stack {
    std::set<std::int32_t> vertices;
    ScanTriangle first;
    std::size_t copies;
};

/// The faces with an area, those on the same vertices in one stack, in the order of the first of each.
std::vector<Stack> stacks_of(const Scan& scan) {
    std::vector<Stack> stacks;
    for (const Triangle& face : scan.faces) {
        const std::set<std::int32_t> vertices(face.begin(), face.end());
        const ScanTriangle triangle = corners(scan, face);
        if (vertices.size() < 3 || (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]) == Vec3::Zero()) {
            continue;
        }
        const auto same = std::ranges::find(stacks, vertices, &Stack::vertices);
        if (same == stacks.end()) {
            stacks.push_back({vertices, triangle, 1});
        } else {
            ++same->copies;
        }
    }
    return stacks;
}

bool is_doubled(const Stack& stack) {
    return stack.copies % 2 == 0;
}

std::size_t common_vertices(const Stack& one, const Stack& other) {
    return static_cast<std::size_t>(
        std::ranges::count_if(one.vertices, [&](std::int32_t vertex) { return other.vertices.contains(vertex); }));
}

/// The doubled stacks that are reached from one over edges.
std::vector<Stack> sheet_of(const Stack& start, const std::vector<Stack>& stacks) {
    std::vector<Stack> sheet{start};
    for (std::size_t i = 0; i < sheet.size(); ++i) {
        for (const Stack& stack : stacks) {
            const bool known = std::ranges::find(sheet, stack.vertices, &Stack::vertices) != sheet.end();
            if (is_doubled(stack) && !known && common_vertices(sheet[i], stack) == 2) {
                sheet.push_back(stack);
            }
        }
    }
    return sheet;
}

/// How many stacks that are not doubled have the edge that the face has without the vertex.
std::size_t others_at(const Stack& face, std::int32_t without, const std::vector<Stack>& stacks) {
    std::set<std::int32_t> edge = face.vertices;
    edge.erase(without);
    return static_cast<std::size_t>(std::ranges::count_if(
        stacks, [&](const Stack& stack) { return !is_doubled(stack) && std::ranges::includes(stack.vertices, edge); }));
}

bool is_thin_wall(const Stack& start, const std::vector<Stack>& stacks) {
    std::size_t all = 0;
    for (const Stack& face : sheet_of(start, stacks)) {
        for (const std::int32_t vertex : face.vertices) {
            const std::size_t others = others_at(face, vertex, stacks);
            if (others % 2 != 0) {
                return false;
            }
            all += others;
        }
    }
    return all > 0;
}

/// The faces that a repair has to keep, from the definition.
std::vector<ScanTriangle> faces_to_keep(const Scan& scan) {
    const std::vector<Stack> stacks = stacks_of(scan);
    std::vector<ScanTriangle> kept;
    for (const Stack& stack : stacks) {
        if (!is_doubled(stack) || !is_thin_wall(stack, stacks)) {
            kept.push_back(stack.first);
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
