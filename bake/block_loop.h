/// \file
/// Parallel loops whose results are gathered the same way whatever the number of threads.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace foldless::distances {

/// A sequence of loops, each a stated share of all work, that can be stopped.
class BlockLoop {
public:
    explicit BlockLoop(const std::function<bool(double)>& progress) : progress_(progress) {}

    [[nodiscard]] bool cancelled() const { return cancelled_; }

    /// Elements of a block, which one thread takes in order.
    static constexpr std::size_t block = 1024;

    [[nodiscard]] static std::size_t blocks(std::size_t n) { return (n + block - 1) / block; }

    /// Calls visit(b, first, last) for each block b of the elements 0 <= i < n, from many threads. After a cancellation
    /// it does nothing.
    template <class Visit>
    void for_each_block(std::size_t n, double share, Visit visit);

    /// Says that so much of the work that follows a loop is done, at most `share` of all.
    void report_within(double share, double part) { report(done_ + share * part); }

    /// Ends a piece of work that was no loop.
    void finish(double share) {
        done_ += share;
        report(done_);
    }

private:
    /// Blocks between two calls of the progress function: some tens of milliseconds of work.
    static constexpr std::size_t blocks_at_once = 16;

    void report(double done) { cancelled_ = cancelled_ || (progress_ && !progress_(std::clamp(done, 0.0, 1.0))); }

    const std::function<bool(double)>& progress_;
    bool cancelled_ = false;
    double done_ = 0.0;
};

template <class Visit>
void BlockLoop::for_each_block(std::size_t n, double share, Visit visit) {
    const std::size_t all = blocks(n);
    for (std::size_t begin = 0; begin < all && !cancelled_; begin += blocks_at_once) {
        const std::size_t end = std::min(all, begin + blocks_at_once);
        tbb::parallel_for(begin, end, [&](std::size_t b) { visit(b, b * block, std::min(n, (b + 1) * block)); });
        report(done_ + share * static_cast<double>(end) / static_cast<double>(all));
    }
    done_ += share;
}

} // namespace foldless::distances
