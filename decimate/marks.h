/// \file
/// A mark for each of many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// One bit for each of the numbers below a count.
class Marks {
public:
    explicit Marks(std::size_t count) : words_((count + word - 1) / word, 0) {}

    /// Whether it had no mark.
    bool mark(std::int32_t number) {
        std::uint64_t& bits = words_[static_cast<std::size_t>(number) / word];
        const std::uint64_t before = bits;
        bits |= bit(number);
        return bits != before;
    }
    void unmark(std::int32_t number) { words_[static_cast<std::size_t>(number) / word] &= ~bit(number); }

private:
    static constexpr std::size_t word = 64;
    [[nodiscard]] static std::uint64_t bit(std::int32_t number) {
        return std::uint64_t{1} << static_cast<std::size_t>(number) % word;
    }

    std::vector<std::uint64_t> words_;
};

} // namespace foldless
