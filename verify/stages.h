/// \file
/// Parallel loops that report how far they have come and can be stopped.
#pragma once

#include <foldless/predicates/sign_counts.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace foldless::verification {

/// The work of a verification as a sequence of loops, each a stated share of the whole.
class Stages {
public:
    explicit Stages(const std::function<bool(double)>& progress) : progress_(progress) {}

    [[nodiscard]] bool cancelled() const { return cancelled_; }

    /// The signs that were asked in the loops.
    [[nodiscard]] SignCounts signs() const { return {filtered_.load(), exact_.load()}; }

    /// Calls visit(i) for 0 <= i < n from many threads, `share` of all work. After a cancellation it does nothing.
    template <class Visit>
    void for_each(std::size_t n, double share, Visit visit);

private:
    /// Elements between two calls of the progress function: some milliseconds of work.
    static constexpr std::size_t block = 16384;

    void report(double done) { cancelled_ = cancelled_ || (progress_ && !progress_(std::min(1.0, done))); }

    const std::function<bool(double)>& progress_;
    bool cancelled_ = false;
    double done_ = 0.0;
    std::atomic<std::uint64_t> filtered_{0};
    std::atomic<std::uint64_t> exact_{0};
};

template <class Visit>
void Stages::for_each(std::size_t n, double share, Visit visit) {
    for (std::size_t first = 0; first < n && !cancelled_; first += block) {
        const std::size_t last = std::min(n, first + block);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              const SignCounts before = sign_counts();
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                  visit(i);
                              }
                              filtered_ += sign_counts().filtered - before.filtered;
                              exact_ += sign_counts().exact - before.exact;
                          });
        report(done_ + share * static_cast<double>(last) / static_cast<double>(n));
    }
    done_ += share;
}

} // namespace foldless::verification
