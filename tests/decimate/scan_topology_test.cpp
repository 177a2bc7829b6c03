#include "made_scans.h"

#include <foldless/decimate/scan_topology.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foldless {
namespace {

using testing::ElementsAre;

TEST(ScanTopology, ListsTheFacesAroundAVertexInOrder) {
    const ScanTopology topology(test::pyramid({0.4, 0.7, 0.3}));
    EXPECT_THAT(topology.faces_around(0), ElementsAre(0, 3));
    EXPECT_THAT(topology.faces_around(2), ElementsAre(1, 2));
    EXPECT_THAT(topology.faces_around(4), ElementsAre(0, 1, 2, 3));
}

TEST(ScanTopology, FollowsTheBorderWithTheSurfaceOnTheLeft) {
    const ScanTopology topology(test::pyramid({0.4, 0.7, 0.3}));
    EXPECT_EQ(topology.border_successor(0), 1);
    EXPECT_EQ(topology.border_successor(1), 2);
    EXPECT_EQ(topology.border_successor(2), 3);
    EXPECT_EQ(topology.border_successor(3), 0);
    EXPECT_EQ(topology.border_successor(4), -1);
}

TEST(ScanTopology, KnowsBorderEdgesFromInnerOnesBetweenBorderVertices) {
    Scan scan = test::pyramid({0, 0, 0});
    scan.faces = {{0, 1, 2}, {0, 2, 3}};
    const ScanTopology topology(scan);
    EXPECT_TRUE(topology.is_border_edge(0, 1));
    EXPECT_TRUE(topology.is_border_edge(1, 0));
    EXPECT_FALSE(topology.is_border_edge(0, 2));
    EXPECT_FALSE(topology.is_border_edge(2, 0));
    EXPECT_TRUE(topology.faces_around(4).empty()); // no face uses it
    EXPECT_EQ(topology.border_successor(4), -1);
}

TEST(ScanTopology, FindsNoBorderOnAClosedSurface) {
    const Scan scan = test::torus(5, 4);
    const ScanTopology topology(scan);
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(scan.positions.size()); ++v) {
        EXPECT_EQ(topology.border_successor(v), -1);
        EXPECT_EQ(topology.faces_around(v).size(), 6);
        for (const std::int32_t f : topology.faces_around(v)) {
            EXPECT_EQ(std::count(scan.faces[f].begin(), scan.faces[f].end(), v), 1);
        }
    }
}

TEST(ScanTopology, GoesAlongTheWholeBorder) {
    const int side = 5;
    const ScanTopology topology(test::terrain(side, 0.1));
    int steps = 0;
    std::int32_t v = 0;
    do {
        const std::int32_t next = topology.border_successor(v);
        ASSERT_GE(next, 0);
        EXPECT_TRUE(topology.is_border_edge(v, next));
        v = next;
        ++steps;
    } while (v != 0 && steps < 100);
    EXPECT_EQ(steps, 4 * side);
}

} // namespace
} // namespace foldless
