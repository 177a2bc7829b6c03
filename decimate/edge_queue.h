/// \file
/// The order in which edges are asked: shortest first, refused ones last.
#pragma once

#include <foldless/decimate/renumbering.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace foldless {

/// A priority queue of edges by length. A refused edge leaves the queue; it comes back behind all edges that were not
/// refused when something in its neighbourhood changes. The order is total: equal lengths go by index.
///
/// Takes 8 bytes for an edge, and 16 for one that is in the queue again, with half as much for stale entries.
class EdgeQueue {
public:
    /// The squared length of an edge as it is. When it has changed, the edge must be pushed or erased before the next
    /// pop().
    using SquaredLength = std::function<double(std::int32_t edge)>;

    EdgeQueue(std::size_t edges, SquaredLength squared_length);

    /// Enters all edges, before any other call. Time O(n log n); takes 16 bytes more for each edge while it sorts them.
    void push_all();
    /// Enters or re-enters an edge whose length is new.
    void push(std::int32_t edge);
    /// Takes an edge out for good.
    void erase(std::int32_t edge);
    /// The neighbourhood of the edge has changed: if it was refused, it is asked again.
    void wake(std::int32_t edge);
    /// Remembers that the edge, just popped, was refused.
    void refuse(std::int32_t edge) { states_[edge].refused = 1; }

    /// Gives the edges that are left new numbers, in the same order. Linear time.
    void renumber(const NewNumbers& numbers);

    /// Appends the next edges to ask, in order, `count` of them if there are as many. They stay in the queue.
    void look_ahead(std::size_t count, std::vector<std::int32_t>& out);

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
        [[nodiscard]] bool operator<(const Entry& other) const { return other > *this; }
    };
    struct State {
        std::uint32_t stamp : 31 = 0; ///< entries with another stamp are stale; 0 for what push_all() enters
        std::uint32_t refused : 1 = 0;
    };

    [[nodiscard]] Entry entry_of(std::int32_t edge, bool refused_before) const;
    [[nodiscard]] bool is_stale(const Entry& entry) const { return entry.stamp != states_[entry.edge].stamp; }
    void enter(const Entry& entry);
    void enter_again(const Entry& entry);
    void enter_from_start();
    void give_back_room();
    [[nodiscard]] const Entry* first_in_queue();
    [[nodiscard]] Entry take_first_in_queue();

    SquaredLength squared_length_;
    std::vector<State> states_;
    std::vector<std::int32_t> start_; ///< edges that wait since push_all(), the next one last
    std::vector<Entry> queue_;        ///< a heap of the others
    std::vector<Entry> ahead_;        ///< taken from there to be looked at, in order
    std::size_t most_entries_;        ///< with more, stale ones are dropped
};

} // namespace foldless
