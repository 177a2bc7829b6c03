/// \file
/// Loops on threads of the standard library, which stand in for those of oneTBB where races are looked for. Debian's
/// library is not instrumented: the thread sanitizer does not see how it hands over work, and would take every parallel
/// loop for a race.
///
/// The threads of a loop share nothing before they are joined, no counter and no lock: whatever orders what they do
/// would hide races between them.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace tbb::stand_in {

inline constexpr std::size_t most_workers = 16;

/// The number of the calling thread in the loop that it runs, from 1; 0 outside of loops.
inline thread_local std::size_t worker = 0;

/// How many threads the loops of the calling thread may take.
inline thread_local std::size_t allowed = std::thread::hardware_concurrency();

/// Of a loop that the calling thread starts: as many as are allowed, at least two.
inline std::size_t workers() {
    return std::clamp<std::size_t>(allowed, 2, most_workers);
}

/// Calls part(k) for 0 <= k < parts, neighbours from different threads. Rethrows one of the exceptions. \pre loops are
/// not nested
template <class Part>
void run(std::size_t parts, const Part& part) {
    assert(worker == 0);
    const std::size_t count = workers();
    std::vector<std::exception_ptr> failures(count);
    std::vector<std::thread> threads;
    for (std::size_t w = 0; w < count; ++w) {
        threads.emplace_back([&, w] {
            worker = w + 1;
            try {
                for (std::size_t k = w; k < parts; k += count) {
                    part(k);
                }
            } catch (...) {
                failures[w] = std::current_exception();
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const std::exception_ptr& failure : failures) {
        if (failure) {
            std::rethrow_exception(failure);
        }
    }
}

} // namespace tbb::stand_in
