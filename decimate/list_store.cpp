#include <foldless/decimate/list_store.h>

#include <limits>
#include <new>

namespace foldless {

ListHandle ListStore::add(std::int32_t owner, std::span<const std::int32_t> list) {
    const std::size_t at = data_.size();
    if (at / unit > std::numeric_limits<ListHandle>::max()) {
        throw std::bad_alloc();
    }
    const auto length = static_cast<std::int32_t>(list.size());
    data_.push_back(owner);
    data_.push_back(length);
    data_.insert(data_.end(), list.begin(), list.end());
    data_.resize(at + size_of(length));
    return static_cast<ListHandle>(at / unit);
}

void ListStore::give_back_room() {
    if (data_.size() < most_ / 2) {
        data_.shrink_to_fit();
        most_ = data_.size();
    }
}

void ListStore::renumber_owners(const NewNumbers& numbers) {
    for (std::size_t at = 0; at < data_.size(); at += size_of(data_[at + 1])) {
        data_[at] = data_[at] == no_owner ? no_owner : numbers[data_[at]];
    }
}

void ListStore::remove(ListHandle list) {
    std::int32_t* head = data_.data() + unit * static_cast<std::size_t>(list);
    head[0] = no_owner;
    removed_ += size_of(head[1]);
}

} // namespace foldless
