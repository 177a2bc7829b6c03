/// \file
/// Numbers given to a few of many indices for a short time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// A map from indices to numbers that is cleared in no time: for what is known of the vertices and
/// faces around one place, where an array over all of them would be too large, and mostly far away in memory.
class IndexMap {
public:
    /// Forgets all, and gives back its memory if that is much.
    void clear();

    /// Memory for so many indices.
    void reserve(std::size_t indices);

    /// The number of an index that is not negative, or -1 if it has none. Constant time.
    [[nodiscard]] std::int32_t find(std::int32_t index) const {
        const Slot& slot = slots_[place_of(index)];
        return slot.stamp == stamp_ ? slot.number : -1;
    }
    [[nodiscard]] bool contains(std::int32_t index) const { return slots_[place_of(index)].stamp == stamp_; }

    /// Gives an index a number, or another one. Constant time, amortised.
    void set(std::int32_t index, std::int32_t number);
    /// Gives it the number 0 unless it has one. True if it had none.
    bool insert(std::int32_t index);

private:
    /// What bears an earlier stamp is free.
    struct Slot {
        std::uint32_t stamp = 0;
        std::int32_t index = -1;
        std::int32_t number = -1;
    };
    static constexpr std::size_t smallest = 64;
    static constexpr std::size_t largest_kept = 65536; ///< when all is forgotten

    /// Where the index is, or the free place where it would be: open addressing, at most half full.
    [[nodiscard]] std::size_t place_of(std::int32_t index) const {
        // An odd multiplier spreads neighbouring indices; the high bits are the well mixed ones.
        std::size_t place = (static_cast<std::uint32_t>(index) * 0x9E3779B1U) >> shift_;
        while (slots_[place].stamp == stamp_ && slots_[place].index != index) {
            place = (place + 1) & (slots_.size() - 1);
        }
        return place;
    }
    void resize(std::size_t slots);

    std::vector<Slot> slots_ = std::vector<Slot>(smallest); ///< their number is a power of two
    int shift_ = 32 - 6;                                    ///< of 32 bits, those that number them are left
    std::uint32_t stamp_ = 1;
    std::size_t count_ = 0;
};

} // namespace foldless
