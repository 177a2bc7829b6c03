#include <foldless/decimate/index_map.h>

#include <bit>
#include <utility>

namespace foldless {

void IndexMap::clear() {
    count_ = 0;
    if (slots_.size() > largest_kept) {
        slots_ = std::vector<Slot>();
        resize(smallest);
    }
    if (++stamp_ == 0) { // all stamps were in use
        slots_.assign(slots_.size(), {});
        stamp_ = 1;
    }
}

void IndexMap::set(std::int32_t index, std::int32_t number) {
    insert(index);
    slots_[place_of(index)].number = number;
}

bool IndexMap::insert(std::int32_t index) {
    const std::size_t place = place_of(index);
    if (slots_[place].stamp == stamp_) {
        return false;
    }
    slots_[place] = {stamp_, index, 0};
    ++count_;
    if (2 * count_ > slots_.size()) {
        resize(2 * slots_.size());
    }
    return true;
}

void IndexMap::reserve(std::size_t indices) {
    const std::size_t slots = std::bit_ceil(2 * indices);
    if (slots > slots_.size()) {
        resize(slots);
    }
}

void IndexMap::resize(std::size_t slots) {
    const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(slots));
    shift_ = 32 - std::countr_zero(slots);
    for (const Slot& slot : before) {
        if (slot.stamp == stamp_) {
            slots_[place_of(slot.index)] = slot;
        }
    }
}

} // namespace foldless
