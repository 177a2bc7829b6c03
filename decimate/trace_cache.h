/// \file
/// The traces of one trial: each scan edge belongs to two scan faces and is followed once.
#pragma once

#include <foldless/decimate/edge_trace.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace foldless {

/// Remembers the crossings of scan edges, by their end vertices, until it is cleared.
class TraceCache {
public:
    void clear();

    /// Appends the crossings of the scan edge between the vertices a < b, as `follow` finds them the first time.
    [[nodiscard]] Verdict trace(std::int32_t a, std::int32_t b,
                                const std::function<Verdict(std::vector<TraceCrossing>&)>& follow,
                                std::vector<TraceCrossing>& crossings);

private:
    struct Entry {
        std::int32_t a, b;
        std::size_t begin, end; ///< of its crossings
        Verdict verdict;
    };
    [[nodiscard]] std::size_t slot(std::int32_t a, std::int32_t b) const;
    void grow();

    std::vector<std::int32_t> table_; ///< entry index or -1, open addressing; the size is a power of two
    std::vector<Entry> entries_;
    std::vector<TraceCrossing> pool_;
};

} // namespace foldless
