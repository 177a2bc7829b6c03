/// \file
/// What this process has used of the machine.
#pragma once

#include <cstddef>

namespace foldless {

/// Processor time of all threads of this process since its start, in seconds.
[[nodiscard]] double process_cpu_seconds();

/// The most physical memory that this process has held at once, in bytes; 0 if the system does not tell.
[[nodiscard]] std::size_t peak_memory_bytes();

} // namespace foldless
