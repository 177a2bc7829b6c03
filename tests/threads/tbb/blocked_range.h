/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

namespace tbb {

template <class Index>
class blocked_range {
public:
    blocked_range(Index begin, Index end) : begin_(begin), end_(end) {}
    [[nodiscard]] Index begin() const { return begin_; }
    [[nodiscard]] Index end() const { return end_; }

private:
    Index begin_;
    Index end_;
};

} // namespace tbb
