#include <foldless/verify/adjacency.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foldless::verification {
namespace {

using testing::ElementsAre;

//     3 --- 2
//     |\   /|
//     |  4  |     faces 0 to 3 from the lower edge counter-clockwise
//     |/   \|
//     0 --- 1
const std::vector<Triangle> faces{{0, 1, 4}, {1, 2, 4}, {4, 2, 3}, {3, 0, 4}};

bool any(std::int32_t) {
    return true;
}

TEST(Adjacency, KnowsFacesOfVerticesAndEdges) {
    const Adjacency adjacency(6, faces);
    EXPECT_THAT(adjacency.faces_around(4), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(adjacency.faces_around(0), ElementsAre(0, 3));
    EXPECT_TRUE(adjacency.faces_around(5).empty());
    EXPECT_EQ(adjacency.face_with(1, 4), 0);
    EXPECT_EQ(adjacency.face_with(4, 1), 1);
    EXPECT_EQ(adjacency.face_with(1, 0), -1);
    EXPECT_EQ(adjacency.neighbour(0, 0), 1); // across (1, 4)
    EXPECT_EQ(adjacency.neighbour(0, 2), -1);
}

TEST(Adjacency, GoesRoundVerticesCounterClockwise) {
    const Adjacency adjacency(6, faces);
    const auto full = adjacency.fans(4, any);
    ASSERT_EQ(full.size(), 1);
    EXPECT_TRUE(full[0].closed);
    EXPECT_THAT(full[0].faces, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(adjacency.spokes(4, full[0]), ElementsAre(0, 1, 2, 3));
    const auto corner = adjacency.fans(0, any);
    ASSERT_EQ(corner.size(), 1);
    EXPECT_FALSE(corner[0].closed);
    EXPECT_THAT(corner[0].faces, ElementsAre(0, 3));
    EXPECT_THAT(adjacency.spokes(0, corner[0]), ElementsAre(1, 4, 3));
}

TEST(Adjacency, CutsFansAtFacesThatAreLeftOut) {
    const Adjacency adjacency(6, faces);
    const auto fans = adjacency.fans(4, [](std::int32_t face) { return face == 1 || face == 3; });
    ASSERT_EQ(fans.size(), 2);
    EXPECT_THAT(fans[0].faces, ElementsAre(1));
    EXPECT_THAT(fans[1].faces, ElementsAre(3));
    EXPECT_TRUE(adjacency.fans(4, [](std::int32_t) { return false; }).empty());
}

} // namespace
} // namespace foldless::verification
