#include <foldless/decimate/edge_queue.h>

#include <bit>

namespace foldless {

std::uint64_t EdgeQueue::rank(bool refused_before, double squared_length) {
    // The bits of doubles that are not negative are in the order of the numbers; the sign bit is free.
    return std::bit_cast<std::uint64_t>(squared_length) | static_cast<std::uint64_t>(refused_before) << 63;
}

void EdgeQueue::push(std::int32_t edge, double squared_length) {
    State& state = states_[edge];
    state = {squared_length, state.stamp + 1, false};
    queue_.push({rank(false, squared_length), edge, state.stamp});
}

void EdgeQueue::erase(std::int32_t edge) {
    ++states_[edge].stamp;
    states_[edge].refused = false;
}

void EdgeQueue::wake(std::int32_t edge) {
    State& state = states_[edge];
    if (state.refused) {
        state.refused = false;
        queue_.push({rank(true, state.squared_length), edge, ++state.stamp});
    }
}

std::optional<std::int32_t> EdgeQueue::pop() {
    while (!queue_.empty()) {
        const Entry entry = queue_.top();
        queue_.pop();
        if (entry.stamp == states_[entry.edge].stamp) {
            return entry.edge;
        }
    }
    return std::nullopt;
}

} // namespace foldless
