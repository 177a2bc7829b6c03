/// \file
/// How many threads a command uses.
#pragma once

#include <tbb/global_control.h>

#include <cstddef>
#include <optional>

namespace foldless {

/// The number of threads that a command uses: those asked for, or all cores.
[[nodiscard]] int threads_to_use(std::optional<int> asked_for);

/// While it lives, the process may have as many threads, more than there are cores, too.
class ThreadAllowance {
public:
    explicit ThreadAllowance(int threads)
        : allowed_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}

private:
    tbb::global_control allowed_;
};

} // namespace foldless
