#include <foldless/decimate/edge_queue.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace foldless {
namespace {

struct Lengths {
    std::vector<double> squared_lengths;
};

/// A queue of edges whose squared lengths are given when they are pushed.
class Queue : public Lengths, public EdgeQueue {
public:
    explicit Queue(std::size_t edges) : Queue(std::vector<double>(edges, 0.0)) {}
    explicit Queue(std::vector<double> lengths)
        : Lengths{std::move(lengths)},
          EdgeQueue(squared_lengths.size(), [this](std::int32_t edge) { return squared_lengths[edge]; }) {}
    void push(std::int32_t edge, double squared_length) {
        squared_lengths[edge] = squared_length;
        EdgeQueue::push(edge);
    }
};

std::vector<std::int32_t> drained(EdgeQueue& queue) {
    std::vector<std::int32_t> edges;
    while (const std::optional<std::int32_t> edge = queue.pop()) {
        edges.push_back(*edge);
    }
    return edges;
}

TEST(EdgeQueue, IsEmptyAtFirst) {
    Queue queue(3);
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, GivesTheShortestFirst) {
    Queue queue(4);
    queue.push(0, 3.0);
    queue.push(1, 1.0);
    queue.push(2, 4.0);
    queue.push(3, 2.0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 3, 0, 2}));
}

// Edges of every kind: still waiting, entered again, refused, looked at, gone.
TEST(EdgeQueue, KeepsTheOrderWhereEdgesHaveNewNumbers) {
    const auto make = [] {
        auto queue = std::make_unique<Queue>(std::vector<double>{5, 1, 4, 2, 8, 6, 6, 3});
        queue->push_all();
        queue->refuse(*queue->pop()); // 1
        queue->push(4, 2.5);
        std::vector<std::int32_t> ahead;
        queue->look_ahead(2, ahead);
        EXPECT_EQ(ahead, (std::vector<std::int32_t>{3, 4}));
        queue->erase(2);
        queue->erase(7);
        return queue;
    };
    const auto as_it_is = make();
    as_it_is->wake(1);
    EXPECT_EQ(drained(*as_it_is), (std::vector<std::int32_t>{3, 4, 0, 5, 6, 1}));
    const auto renumbered = make();
    renumbered->renumber(NewNumbers(8, [](std::int32_t edge) { return edge != 2 && edge != 7; }));
    renumbered->squared_lengths = {5, 1, 2, 2.5, 6, 6};
    renumbered->wake(1);
    EXPECT_EQ(drained(*renumbered), (std::vector<std::int32_t>{2, 3, 0, 4, 5, 1}));
}

TEST(EdgeQueue, BreaksTiesByIndex) {
    Queue queue(4);
    for (const std::int32_t edge : {2, 0, 3, 1}) {
        queue.push(edge, 1.0);
    }
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(EdgeQueue, ForgetsTheLengthBeforeTheLast) {
    Queue queue(2);
    queue.push(0, 1.0);
    queue.push(1, 2.0);
    queue.push(0, 3.0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 0}));
}

TEST(EdgeQueue, GivesAnErasedEdgeNoMore) {
    Queue queue(2);
    queue.push(0, 1.0);
    queue.push(1, 2.0);
    queue.erase(0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1}));
}

TEST(EdgeQueue, KeepsARefusedEdgeUntilItIsWoken) {
    Queue queue(1);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    EXPECT_FALSE(queue.pop());
    queue.wake(0);
    EXPECT_EQ(queue.pop(), 0);
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, GivesAWokenEdgeAfterAllThatWereNotRefused) {
    Queue queue(3);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.push(1, 5.0);
    queue.wake(0);
    queue.push(2, 9.0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 2, 0}));
}

TEST(EdgeQueue, OrdersWokenEdgesByLengthToo) {
    Queue queue(3);
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
    Queue queue(2);
    queue.push(0, 1.0);
    queue.wake(0);
    queue.wake(1);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0}));
    queue.wake(0); // given, but not refused
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, AsksAWokenEdgeOnceHoweverOftenItIsWoken) {
    Queue queue(1);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.wake(0);
    queue.wake(0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0}));
}

TEST(EdgeQueue, ANewLengthEndsARefusal) {
    Queue queue(2);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.push(1, 2.0);
    queue.push(0, 1.5);
    queue.wake(0); // would come behind edge 1 if the refusal still stood
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{0, 1}));
}

TEST(EdgeQueue, AnErasedEdgeStaysErasedWhenItIsWoken) {
    Queue queue(1);
    queue.push(0, 1.0);
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.erase(0);
    queue.wake(0);
    EXPECT_FALSE(queue.pop());
}

TEST(EdgeQueue, StartsWithAllEdges) {
    Queue queue({3.0, 1.0, 4.0, 1.0});
    queue.push_all();
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 3, 0, 2}));
}

TEST(EdgeQueue, PutsNewLengthsAmongThoseOfTheStart) {
    Queue queue({1.0, 2.0, 3.0, 4.0, 5.0});
    queue.push_all();
    queue.push(0, 3.5);
    queue.push(4, 2.5);
    queue.erase(1);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{4, 2, 0, 3}));
}

TEST(EdgeQueue, WakesAnEdgeOfTheStart) {
    Queue queue({1.0, 2.0, 3.0});
    queue.push_all();
    ASSERT_EQ(queue.pop(), 0);
    queue.refuse(0);
    queue.wake(0);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 2, 0}));
}

// So often that stale entries are dropped many times; the order is that of a sorted list.
TEST(EdgeQueue, KeepsTheOrderWhenStaleEntriesAreDropped) {
    constexpr std::int32_t edges = 2000;
    std::mt19937 random(3);
    std::vector<double> lengths(edges);
    const auto draw = [&] { return static_cast<double>(random() % 1000); };
    std::generate(lengths.begin(), lengths.end(), draw);
    Queue queue(lengths);
    queue.push_all();
    std::set<std::pair<double, std::int32_t>> expected;
    for (std::int32_t edge = 0; edge < edges; ++edge) {
        expected.emplace(lengths[edge], edge);
    }
    while (!expected.empty()) {
        for (int n = 0; n < 5 && expected.size() > edges / 3; ++n) {
            const auto edge = static_cast<std::int32_t>(random() % edges);
            if (expected.erase({lengths[edge], edge}) == 0) {
                continue; // given or erased before
            }
            lengths[edge] = draw();
            expected.emplace(lengths[edge], edge);
            queue.push(edge, lengths[edge]);
        }
        if (random() % 3 == 0 || expected.size() <= edges / 3) {
            ASSERT_EQ(queue.pop(), expected.begin()->second);
            expected.erase(expected.begin());
        } else {
            const std::int32_t last = expected.rbegin()->second;
            expected.erase({lengths[last], last});
            queue.erase(last);
        }
    }
    EXPECT_FALSE(queue.pop());
}

std::vector<std::int32_t> next_edges(EdgeQueue& queue, std::size_t count) {
    std::vector<std::int32_t> edges;
    queue.look_ahead(count, edges);
    return edges;
}

TEST(EdgeQueue, ShowsTheNextEdgesAndKeepsThem) {
    Queue queue(4);
    queue.push(0, 3.0);
    queue.push(1, 1.0);
    queue.push(2, 4.0);
    queue.push(3, 2.0);
    EXPECT_EQ(next_edges(queue, 0), std::vector<std::int32_t>{});
    EXPECT_EQ(next_edges(queue, 2), (std::vector<std::int32_t>{1, 3}));
    EXPECT_EQ(next_edges(queue, 9), (std::vector<std::int32_t>{1, 3, 0, 2}));
    EXPECT_EQ(next_edges(queue, 1), std::vector<std::int32_t>{1});
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{1, 3, 0, 2}));
    EXPECT_EQ(next_edges(queue, 9), std::vector<std::int32_t>{});
}

TEST(EdgeQueue, PutsWhatComesLaterBetweenWhatWasShown) {
    Queue queue(6);
    queue.push(0, 2.0);
    queue.push(1, 4.0);
    queue.push(2, 6.0);
    EXPECT_EQ(next_edges(queue, 3), (std::vector<std::int32_t>{0, 1, 2}));
    queue.push(3, 5.0);
    queue.push(4, 1.0);
    queue.push(1, 7.0); // its old length was shown
    EXPECT_EQ(next_edges(queue, 2), (std::vector<std::int32_t>{4, 0}));
    queue.push(5, 3.0);
    queue.erase(2);
    EXPECT_EQ(drained(queue), (std::vector<std::int32_t>{4, 0, 5, 3, 1}));
}

TEST(EdgeQueue, GivesTheSameOrderHoweverOftenItIsLookedAt) {
    Queue looked_at(50);
    Queue queue(50);
    unsigned state = 1;
    const auto drawn = [&state](unsigned below) {
        state = 1664525 * state + 1013904223;
        return static_cast<std::int32_t>((state >> 16) % below);
    };
    for (int step = 0; step < 5000; ++step) {
        const std::int32_t edge = drawn(50);
        const std::int32_t kind = drawn(4);
        if (kind < 2) {
            const double length = drawn(20);
            looked_at.push(edge, length);
            queue.push(edge, length);
        } else if (kind == 2) {
            looked_at.wake(edge);
            queue.wake(edge);
        } else {
            const std::optional<std::int32_t> next = queue.pop();
            EXPECT_EQ(looked_at.pop(), next);
            if (next && drawn(2) == 0) {
                looked_at.refuse(*next);
                queue.refuse(*next);
            }
        }
        static_cast<void>(next_edges(looked_at, static_cast<std::size_t>(drawn(12))));
    }
    EXPECT_EQ(drained(looked_at), drained(queue));
}

} // namespace
} // namespace foldless
