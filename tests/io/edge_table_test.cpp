#include <foldless/io/edge_table.h>

#include <gtest/gtest.h>

#include <vector>

namespace foldless {
namespace {

struct Edge {
    std::int32_t a;
    std::int32_t b;
    std::vector<std::int32_t> faces;
    bool operator==(const Edge&) const = default;
};

std::vector<Edge> edges_of(const std::vector<Triangle>& faces, std::size_t vertices) {
    std::vector<Edge> edges;
    EdgeTable(faces, vertices).for_each_edge([&](std::int32_t a, std::int32_t b, auto entries) {
        edges.push_back({a, b, {}});
        for (const EdgeTable::Entry& entry : entries) {
            edges.back().faces.push_back(entry.face);
        }
    });
    return edges;
}

TEST(EdgeTable, ListsEveryEdgeWithItsFacesInOrder) {
    const std::vector<Edge> expected{{0, 1, {0}}, {0, 2, {0, 1}}, {0, 3, {1}}, {1, 2, {0}}, {2, 3, {1}}};
    EXPECT_EQ(edges_of({{0, 1, 2}, {0, 2, 3}}, 5), expected);
}

TEST(EdgeTable, LeavesOutFacesWithoutThreeVerticesOfTheMesh) {
    const std::vector<Edge> expected{{0, 1, {3}}, {0, 2, {3}}, {1, 2, {3}}};
    EXPECT_EQ(edges_of({{0, 1, 1}, {0, 1, 3}, {-1, 0, 1}, {2, 1, 0}, {2, 1, 2}}, 3), expected);
}

TEST(EdgeTable, IsEmptyWithoutFaces) {
    EXPECT_TRUE(edges_of({}, 0).empty());
    EXPECT_TRUE(edges_of({}, 3).empty());
}

} // namespace
} // namespace foldless
