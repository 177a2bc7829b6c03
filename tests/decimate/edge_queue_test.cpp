#include <foldless/decimate/edge_queue.h>

#include <gtest/gtest.h>

#include <vector>

namespace foldless {
namespace {

std::vector<std::int32_t> drained(EdgeQueue& queue) {
    std::vector<std::int32_t> edges;
    while (const std::optional<std::int32_t> edge = queue.pop()) {
        edges.push_back(*edge);
    }
    return edges;
}

TEST(EdgeQueue, IsEmptyAtFirst) {
    EdgeQueue queue(3);
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, GivesTheShortestFirst) {
    EdgeQueue queue(4);
    queue.push(0, 3.0);
    queue.push(1, 1.0);
    queue.push(2, 4.0);
    queue.push(3, 2.0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 3, 0, 2}));
}

TEST(EdgeQueue, BreaksTiesByIndex) {
    EdgeQueue queue(4);
    for (const std::int32_t edge : {2, 0, 3, 1}) {
        queue.push(edge, 1.0);
    }
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(EdgeQueue, ForgetsTheLengthBeforeTheLast) {
    EdgeQueue queue(2);
    queue.push(0, 1.0);
    queue.push(1, 2.0);
    queue.push(0, 3.0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 0}));
}

TEST(EdgeQueue, GivesAnErasedEdgeNoMore) {
    EdgeQueue queue(2);
    queue.push(0, 1.0);
    queue.push(1, 2.0);
    queue.erase(0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1}));
}

TEST(EdgeQueue, KeepsARefusedEdgeUntilItIsWoken) {
    EdgeQueue queue(1);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    EXPECT_FALSE(queue.pop());
    queue.wake(0);
    EXPECT_EQ(queue.pop(), 0);
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, GivesAWokenEdgeAfterAllThatWereNotRefused) {
    EdgeQueue queue(3);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.push(1, 5.0);
    queue.wake(0);
    queue.push(2, 9.0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 2, 0}));
}

TEST(EdgeQueue, OrdersWokenEdgesByLengthToo) {
    EdgeQueue queue(3);
    queue.push(0, 3.0);
    queue.push(1, 1.0);
    queue.push(2, 2.0);
    for (const std::int32_t edge : drained(queue)) {
        queue.refuse(edge);
    }
    for (const std::int32_t edge : {0, 1, 2}) {
        queue.wake(edge);
    }
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 2, 0}));
}

TEST(EdgeQueue, WakesOnlyRefusedEdges) {
    EdgeQueue queue(2);
    queue.push(0, 1.0);
    queue.wake(0);
    queue.wake(1);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0}));
    queue.wake(0); // given, but not refused
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, AsksAWokenEdgeOnceHoweverOftenItIsWoken) {
    EdgeQueue queue(1);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.wake(0);
    queue.wake(0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0}));
}

TEST(EdgeQueue, ANewLengthEndsARefusal) {
    EdgeQueue queue(2);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.push(1, 2.0);
    queue.push(0, 1.5);
    queue.wake(0); // would come behind edge 1 if the refusal still stood
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0, 1}));
}

TEST(EdgeQueue, AnErasedEdgeStaysErasedWhenItIsWoken) {
    EdgeQueue queue(1);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.erase(0);
    queue.wake(0);
    EXPECT_FALSE(queue.pop());
}

} // namespace
} // namespace foldless
