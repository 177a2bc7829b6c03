/// \file
/// How signs were decided, and whether filters may decide them.
#pragma once

#include <cstdint>

namespace foldless {

/// Signs that rounded arithmetic with error bounds decided, and those that needed exact numbers.
struct SignCounts {
    std::uint64_t filtered = 0;
    std::uint64_t exact = 0;
};

/// Those of the calling thread since it started: the difference of two readings counts what lies between them.
[[nodiscard]] const SignCounts& sign_counts();

/// For tests: with `false` no filter decides anything, in any thread, until it is set back. Every sign then takes the
/// exact branch, and must be the same.
void set_filters_enabled(bool enabled);
[[nodiscard]] bool filters_enabled();

} // namespace foldless
