/// \file
/// Lists of numbers of many owners, side by side in one array.
#pragma once

#include <foldless/decimate/renumbering.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// Where a list is in a store, until the next call of compact().
using ListHandle = std::int32_t;

/// Lists that are written once, read, and removed. Takes 8 bytes for a list beside its numbers, rounded up to a
/// multiple of 8, and for removed ones a seventh of that, as long as the owners call compact() whenever is_wasteful().
/// A heap block for each list takes twice as much.
class ListStore {
public:
    /// Address space for so many numbers: growing beyond it needs the old and the new array for a moment.
    void reserve(std::size_t numbers) { data_.reserve(numbers); }

    /// Writes a list. Time linear in its length. The numbers must not lie in the store.
    /// \throws std::bad_alloc
    [[nodiscard]] ListHandle add(std::int32_t owner, std::span<const std::int32_t> list);

    /// The list. Valid until the next change.
    [[nodiscard]] std::span<const std::int32_t> operator[](ListHandle list) const {
        const std::int32_t* head = data_.data() + unit * static_cast<std::size_t>(list);
        return {head + header, static_cast<std::size_t>(head[1])};
    }

    void remove(ListHandle list);

    /// Gives the owners new numbers. Time linear in the size of the store.
    void renumber_owners(const NewNumbers& numbers);

    /// Whether an eighth of the store or more is removed lists.
    [[nodiscard]] bool is_wasteful() const { return removed_ > least_waste && removed_ >= data_.size() / 8; }

    /// Closes the gaps and calls moved(owner, handle) for each list. Time linear in the size of the store, which
    /// is_wasteful() spreads over the lists that were removed.
    template <class Moved>
    void compact(const Moved& moved) {
        most_ = std::max(most_, data_.size());
        std::size_t end = 0;
        for (std::size_t at = 0; at < data_.size();) {
            const std::size_t size = size_of(data_[at + 1]);
            if (data_[at] != no_owner) {
                std::copy_n(data_.data() + at, size, data_.data() + end); // forwards: the target is never behind
                moved(data_[end], static_cast<ListHandle>(end / unit));
                end += size;
            }
            at += size;
        }
        data_.resize(end);
        removed_ = 0;
        give_back_room();
    }

    /// Numbers in the array, those of gaps and headers included.
    [[nodiscard]] std::size_t size() const { return data_.size(); }

private:
    static constexpr std::size_t unit = 2;   ///< handles count pairs, and so reach 2^32 numbers
    static constexpr std::size_t header = 2; ///< owner, length
    static constexpr std::int32_t no_owner = -1;
    static constexpr std::size_t least_waste = 1024; ///< below which closing gaps saves nothing to speak of

    [[nodiscard]] static std::size_t size_of(std::int32_t length) {
        return header + (static_cast<std::size_t>(length) + 1) / unit * unit;
    }

    void give_back_room();

    std::vector<std::int32_t> data_; ///< one list after the other: owner, length, numbers, perhaps one more
    std::size_t removed_ = 0;        ///< numbers in gaps
    std::size_t most_ = 0;           ///< size since room was given back, as far as compact() has seen
};

} // namespace foldless
