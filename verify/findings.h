/// \file
/// Counts violations from many threads, and keeps the first few of each kind in an order that no thread decides.
#pragma once

#include <foldless/verify/verify.h>

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <vector>

namespace foldless::verification {

/// How many violations of each kind are located: enough to look at, few enough to print.
inline constexpr std::size_t located_of_each_kind = 8;

class Findings {
public:
    /// Records a violation; may be called from any thread.
    void add(const LocatedViolation& violation);
    /// Writes counts and located violations, those of the lowest indices of each kind.
    void write(VerifyResult& result) const;

private:
    struct Local {
        std::array<std::size_t, violation_count> counts{};
        std::array<std::vector<LocatedViolation>, violation_count> first; ///< ascending, at most located_of_each_kind
        void keep(const LocatedViolation& violation);
    };
    tbb::enumerable_thread_specific<Local> local_;
};

} // namespace foldless::verification
