/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h. No code of ours runs in its threads but the
/// comparison of two pairs of numbers.
#pragma once

#include <algorithm>

namespace tbb {

template <class Iterator>
void parallel_sort(Iterator first, Iterator last) {
    std::sort(first, last);
}

} // namespace tbb
