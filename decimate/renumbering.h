/// \file
/// New numbers for what is left of the base mesh.
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

#include <bit>
#include <cstdint>
#include <vector>

namespace foldless {

/// New numbers for some of many, in the same order: 1.5 bits for each.
class NewNumbers {
public:
    /// For those of the numbers below `count` of which `is_left` is true, from 0 on. Linear time.
    template <class IsLeft>
    NewNumbers(std::size_t count, const IsLeft& is_left) : before_(count), words_((count + word - 1) / word) {
        for (std::size_t old = 0; old < count; ++old) {
            Word& bits = words_[old / word];
            bits.left_before = old % word == 0 ? left_ : bits.left_before;
            if (is_left(static_cast<std::int32_t>(old))) {
                bits.left |= std::uint64_t{1} << old % word;
                ++left_;
            }
        }
    }

    /// How many there were, and how many are left.
    [[nodiscard]] std::size_t before() const { return before_; }
    [[nodiscard]] std::size_t left() const { return left_; }

    /// The new number, or -1 for what is not left. Constant time.
    [[nodiscard]] std::int32_t operator[](std::int32_t old) const {
        const Word& bits = words_[static_cast<std::size_t>(old) / word];
        const std::uint64_t from_here = bits.left >> static_cast<std::size_t>(old) % word;
        const int left_of_word = std::popcount(bits.left) - std::popcount(from_here);
        return (from_here & 1) == 0 ? -1 : static_cast<std::int32_t>(bits.left_before) + left_of_word;
    }

private:
    static constexpr std::size_t word = 64;
    struct Word {
        std::uint64_t left = 0; ///< one bit for each, the first in the lowest
        std::uint32_t left_before = 0;
    };
    std::size_t before_;
    std::uint32_t left_ = 0;
    std::vector<Word> words_;
};

/// The new numbers of the edges and faces of a base mesh.
struct Renumbering {
    NewNumbers edges;
    NewNumbers faces;
};

/// Of what is not deleted. Linear time.
[[nodiscard]] Renumbering number_what_is_left(const OpenMesh::PolyConnectivity& mesh);

/// Moves the values of what is left to its new numbers, and gives back the room of the others.
template <class Value>
void renumber(std::vector<Value>& values, const NewNumbers& numbers) {
    for (std::size_t old = 0; old < numbers.before(); ++old) {
        const std::int32_t number = numbers[static_cast<std::int32_t>(old)];
        if (number >= 0) {
            values[number] = values[old]; // never further back
        }
    }
    values.resize(numbers.left());
    values.shrink_to_fit();
}

} // namespace foldless
