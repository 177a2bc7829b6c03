/// \file
/// The traces of one trial: each scan edge belongs to two scan faces and is followed once.
#pragma once

#include <foldless/decimate/edge_trace.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// Remembers the crossings of scan edges, by their end vertices, until it is cleared.
class TraceCache {
public:
    void clear();

    /// Appends the crossings of the scan edge between the vertices a < b, as `follow` finds them the first time.
    template <class Follow>
    [[nodiscard]] Verdict trace(std::int32_t a, std::int32_t b, const Follow& follow,
                                std::vector<TraceCrossing>& crossings) {
        const std::size_t at = slot(a, b);
        if (is_free(table_[at])) {
            const std::size_t begin = pool_.size();
            const Verdict verdict = follow(pool_);
            insert(at, {a, b, begin, pool_.size(), verdict});
            crossings.insert(crossings.end(), pool_.begin() + static_cast<std::ptrdiff_t>(begin), pool_.end());
            return verdict;
        }
        const Entry& entry = entries_[table_[at].entry];
        crossings.insert(crossings.end(), pool_.begin() + static_cast<std::ptrdiff_t>(entry.begin),
                         pool_.begin() + static_cast<std::ptrdiff_t>(entry.end));
        return entry.verdict;
    }

private:
    struct Entry {
        std::int32_t a, b;
        std::size_t begin, end; ///< of its crossings
        Verdict verdict;
    };
    /// A place of the table; what an earlier trial left there is free.
    struct Slot {
        std::uint32_t trial = 0;
        std::int32_t entry = -1;
    };
    [[nodiscard]] bool is_free(const Slot& slot) const { return slot.trial != trial_; }
    [[nodiscard]] std::size_t slot(std::int32_t a, std::int32_t b) const;
    void insert(std::size_t at, const Entry& entry);

    std::uint32_t trial_ = 0;
    std::vector<Slot> table_; ///< open addressing; the size is a power of two
    std::vector<Entry> entries_;
    std::vector<TraceCrossing> pool_;
};

} // namespace foldless
