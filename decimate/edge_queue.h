/// \file
/// The order in which edges are asked: shortest first, refused ones last.
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

namespace foldless {

/// A priority queue of edges by length. A refused edge leaves the queue; it comes back behind all edges that were not
/// refused when something in its neighbourhood changes. The order is total: equal lengths go by index.
class EdgeQueue {
public:
    explicit EdgeQueue(std::size_t edges) : states_(edges) {}

    /// Enters or re-enters an edge whose length is new.
    void push(std::int32_t edge, double squared_length);
    /// Takes an edge out for good.
    void erase(std::int32_t edge);
    /// The neighbourhood of the edge has changed: if it was refused, it is asked again.
    void wake(std::int32_t edge);
    /// Remembers that the edge, just popped, was refused.
    void refuse(std::int32_t edge) { states_[edge].refused = true; }

    /// The next edge to ask, or nothing.
    [[nodiscard]] std::optional<std::int32_t> pop();

private:
    /// 16 bytes, and compared without a branch: heaps compare what no processor can predict.
    struct Entry {
        std::uint64_t rank; ///< edges that were refused behind the others, then by length
        std::int32_t edge;
        std::uint32_t stamp;
        [[nodiscard]] bool operator>(const Entry& other) const {
            return (rank > other.rank) | ((rank == other.rank) & (edge > other.edge));
        }
    };
    [[nodiscard]] static std::uint64_t rank(bool refused_before, double squared_length);
    struct State {
        double squared_length = 0;
        std::uint32_t stamp = 0; ///< entries with another stamp are stale
        bool refused = false;
    };
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::vector<State> states_;
};

} // namespace foldless
