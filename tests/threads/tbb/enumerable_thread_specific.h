/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

#include <tbb/stand_in.h>

#include <vector>

namespace tbb {

/// One value for each thread of a loop, and one for what is outside of loops: copies of the first.
template <class Value>
class enumerable_thread_specific {
public:
    explicit enumerable_thread_specific(Value first = {}) : values_(1 + stand_in::most_workers, first) {}

    Value& local() { return values_[stand_in::worker]; }

    [[nodiscard]] auto begin() const { return values_.begin(); }
    [[nodiscard]] auto end() const { return values_.end(); }

private:
    std::vector<Value> values_;
};

} // namespace tbb
