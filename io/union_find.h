/// \file
/// Disjoint sets of the numbers from 0 to n - 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace foldless {

/// Disjoint sets with union by number and path halving. The number of a set is its smallest member.
class UnionFind {
public:
    explicit UnionFind(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

    [[nodiscard]] std::uint32_t find(std::uint32_t member) {
        while (parent_[member] != member) {
            parent_[member] = parent_[parent_[member]];
            member = parent_[member];
        }
        return member;
    }

    /// Joins two sets; false if they are one already.
    bool join(std::uint32_t a, std::uint32_t b) {
        std::uint32_t low = find(a);
        std::uint32_t high = find(b);
        if (low == high) {
            return false;
        }
        if (low > high) {
            std::swap(low, high);
        }
        parent_[high] = low;
        return true;
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Disjoint sets whose members each have one of two sides, known relative to each other within a set.
class SidedUnionFind {
public:
    explicit SidedUnionFind(std::size_t size) : parent_(size), flipped_(size, 0), contradiction_(size, 0) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    /// States that a and b lie on opposite sides, or on the same one. If that contradicts what was stated before, their
    /// set is marked.
    void join(std::uint32_t a, std::uint32_t b, bool opposite) {
        auto [low, low_flipped] = find(a);
        auto [high, high_flipped] = find(b);
        const bool across = (low_flipped != high_flipped) != opposite;
        if (low == high) {
            contradiction_[low] = across ? 1 : contradiction_[low];
            return;
        }
        if (low > high) {
            std::swap(low, high);
        }
        parent_[high] = low;
        flipped_[high] = across ? 1 : 0;
        contradiction_[low] = contradiction_[high] != 0 ? 1 : contradiction_[low];
    }

    /// The number of sets in which a contradiction was stated.
    [[nodiscard]] std::size_t contradictions() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < parent_.size(); ++i) {
            count += parent_[i] == i && contradiction_[i] != 0 ? 1 : 0;
        }
        return count;
    }

private:
    struct Place {
        std::uint32_t root;
        bool flipped; ///< lies on the other side than the root
    };

    // Path halving keeps the sides: a member hung from its grandparent is flipped by both steps.
    Place find(std::uint32_t member) {
        bool flipped = false;
        while (parent_[member] != member) {
            const std::uint32_t parent = parent_[member];
            const bool parent_flipped = parent_[parent] != parent && flipped_[parent] != 0;
            flipped_[member] = (flipped_[member] != 0) != parent_flipped ? 1 : 0;
            parent_[member] = parent_[parent];
            flipped = flipped != (flipped_[member] != 0);
            member = parent_[member];
        }
        return {member, flipped};
    }

    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> flipped_; ///< relative to the parent
    std::vector<std::uint8_t> contradiction_;
};

} // namespace foldless
