#include <foldless/decimate/edge_queue.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace foldless {
namespace {

/// Below, dropping stale entries saves nothing to speak of.
constexpr std::size_t few_entries = 1024;

} // namespace

EdgeQueue::EdgeQueue(std::size_t edges, SquaredLength squared_length)
    : squared_length_(std::move(squared_length)), states_(edges), most_entries_(few_entries) {
    queue_.reserve(edges); // address space: seldom are so many in it
}

EdgeQueue::Entry EdgeQueue::entry_of(std::int32_t edge, bool refused_before) const {
    // The bits of doubles that are not negative are in the order of the numbers; the sign bit is free.
    const auto length = std::bit_cast<std::uint64_t>(squared_length_(edge));
    return {length | static_cast<std::uint64_t>(refused_before) << 63, edge, states_[edge].stamp};
}

void EdgeQueue::push_all() {
    std::vector<Entry> all;
    all.reserve(states_.size());
    for (std::size_t edge = 0; edge < states_.size(); ++edge) {
        all.push_back(entry_of(static_cast<std::int32_t>(edge), false));
    }
    std::sort(all.begin(), all.end(), std::greater<>());
    start_.reserve(all.size());
    for (const Entry& entry : all) {
        start_.push_back(entry.edge);
    }
}

/// Sees to it that the next entry of all is in queue_: the next edge of start_ enters if it is not behind the others.
void EdgeQueue::enter_from_start() {
    while (!start_.empty() && states_[start_.back()].stamp != 0) {
        start_.pop_back(); // entered again or erased since
    }
    if (start_.empty()) {
        give_back_room();
        return;
    }
    const Entry entry = entry_of(start_.back(), false);
    if (queue_.empty() || queue_.front() > entry) {
        start_.pop_back();
        enter(entry);
    }
}

/// From the end of start_ on the queue only gets smaller, on the whole. The last patches of a decimation, which hold
/// much of the scan, need the room.
void EdgeQueue::give_back_room() {
    start_.shrink_to_fit();
    if (queue_.capacity() > few_entries && queue_.size() < queue_.capacity() / 4) {
        queue_.shrink_to_fit();
    }
}

void EdgeQueue::enter(const Entry& entry) {
    queue_.push_back(entry);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

/// At most a third of the entries is stale for long. The order is total, so that it does not matter how the heap is
/// built.
void EdgeQueue::enter_again(const Entry& entry) {
    enter(entry);
    if (queue_.size() > most_entries_) {
        std::erase_if(queue_, [&](const Entry& old) { return is_stale(old); });
        std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
        most_entries_ = std::max(few_entries, queue_.size() + queue_.size() / 2);
    }
}

void EdgeQueue::push(std::int32_t edge) {
    ++states_[edge].stamp;
    states_[edge].refused = 0;
    enter_again(entry_of(edge, false));
}

void EdgeQueue::erase(std::int32_t edge) {
    ++states_[edge].stamp;
    states_[edge].refused = 0;
}

void EdgeQueue::wake(std::int32_t edge) {
    if (states_[edge].refused != 0) {
        ++states_[edge].stamp;
        states_[edge].refused = 0;
        enter_again(entry_of(edge, true));
    }
}

void EdgeQueue::renumber(const NewNumbers& numbers) {
    std::erase_if(start_, [&](std::int32_t edge) { return states_[edge].stamp != 0; });
    std::erase_if(queue_, [&](const Entry& entry) { return is_stale(entry); });
    std::erase_if(ahead_, [&](const Entry& entry) { return is_stale(entry); });
    for (std::int32_t& edge : start_) {
        edge = numbers[edge];
    }
    for (std::vector<Entry>* entries : {&queue_, &ahead_}) {
        for (Entry& entry : *entries) {
            entry.edge = numbers[entry.edge];
        }
    }
    std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
    foldless::renumber(states_, numbers);
    start_.shrink_to_fit();
}

/// The next entry but for those that were looked at, or null.
const EdgeQueue::Entry* EdgeQueue::first_in_queue() {
    enter_from_start();
    return queue_.empty() ? nullptr : &queue_.front();
}

EdgeQueue::Entry EdgeQueue::take_first_in_queue() {
    const Entry entry = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    queue_.pop_back();
    return entry;
}

void EdgeQueue::look_ahead(std::size_t count, std::vector<std::int32_t>& out) {
    std::erase_if(ahead_, [&](const Entry& entry) { return is_stale(entry); });
    while (const Entry* next = count > 0 ? first_in_queue() : nullptr) {
        if (ahead_.size() >= count && ahead_.back() < *next) {
            break;
        }
        const Entry entry = take_first_in_queue();
        if (!is_stale(entry)) {
            ahead_.insert(std::upper_bound(ahead_.begin(), ahead_.end(), entry), entry);
        }
    }
    for (std::size_t n = 0; n < std::min(count, ahead_.size()); ++n) {
        out.push_back(ahead_[n].edge);
    }
}

std::optional<std::int32_t> EdgeQueue::pop() {
    for (;;) {
        const Entry* next = first_in_queue();
        if (next == nullptr && ahead_.empty()) {
            return std::nullopt;
        }
        Entry entry{};
        if (ahead_.empty() || (next != nullptr && *next < ahead_.front())) {
            entry = take_first_in_queue();
        } else {
            entry = ahead_.front();
            ahead_.erase(ahead_.begin());
        }
        if (!is_stale(entry)) {
            return entry.edge;
        }
    }
}

} // namespace foldless
