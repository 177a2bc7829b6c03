/// \file
/// Values that come and go, in one array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// Values by number. The number of a value that is removed goes to one that comes, so that the pool is as large as most
/// values were in it at once. All calls take constant time.
template <class Value>
class Pool {
public:
    /// Address space for so many values: growing beyond it needs the old and the new array for a moment.
    void reserve(std::size_t values) { values_.reserve(values); }

    [[nodiscard]] std::int32_t add(const Value& value) {
        if (holes_.empty()) {
            values_.push_back(value);
            return static_cast<std::int32_t>(values_.size()) - 1;
        }
        const std::int32_t number = holes_.back();
        holes_.pop_back();
        values_[number] = value;
        return number;
    }
    void remove(std::int32_t number) { holes_.push_back(number); }

    /// Whether the pool has more than four times the room that its values need.
    [[nodiscard]] bool is_sparse() const {
        return values_.size() > few_values && holes_.size() > values_.size() / 4 * 3;
    }
    /// How many values are in the pool.
    [[nodiscard]] std::size_t size() const { return values_.size() - holes_.size(); }

    [[nodiscard]] const Value& operator[](std::int32_t number) const { return values_[number]; }
    [[nodiscard]] Value& operator[](std::int32_t number) { return values_[number]; }

private:
    static constexpr std::size_t few_values = 1024; ///< below, room is nothing to speak of

    std::vector<Value> values_;
    std::vector<std::int32_t> holes_;
};

} // namespace foldless
