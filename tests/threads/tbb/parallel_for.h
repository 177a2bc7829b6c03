/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/stand_in.h>

#include <algorithm>
#include <cstddef>

namespace tbb {

/// In many pieces, so that most neighbours are visited by different threads.
template <class Body>
void parallel_for(const blocked_range<std::size_t>& range, const Body& body) {
    constexpr std::size_t most_parts = 64;
    const std::size_t count = range.end() - range.begin();
    const std::size_t parts = std::min(count, most_parts);
    stand_in::run(parts, [&](std::size_t k) {
        body(blocked_range<std::size_t>(range.begin() + k * count / parts, range.begin() + (k + 1) * count / parts));
    });
}

template <class Body>
void parallel_for(std::size_t first, std::size_t last, const Body& body) {
    parallel_for(blocked_range<std::size_t>(first, last), [&](const blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            body(i);
        }
    });
}

} // namespace tbb
