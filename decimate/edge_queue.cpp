#include <foldless/decimate/edge_queue.h>

#include <tuple>

namespace foldless {

bool EdgeQueue::Entry::operator>(const Entry& other) const {
    return std::tie(asked_before, squared_length, edge) >
           std::tie(other.asked_before, other.squared_length, other.edge);
}

void EdgeQueue::push(std::int32_t edge, double squared_length) {
    State& state = states_[edge];
    state = {squared_length, state.stamp + 1, false};
    queue_.push({false, squared_length, edge, state.stamp});
}

void EdgeQueue::erase(std::int32_t edge) {
    ++states_[edge].stamp;
    states_[edge].refused = false;
}

void EdgeQueue::wake(std::int32_t edge) {
    State& state = states_[edge];
    if (state.refused) {
        state.refused = false;
        queue_.push({true, state.squared_length, edge, ++state.stamp});
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
