/// \file
/// How much memory some work takes.
#pragma once

#include <cstddef>
#include <functional>

namespace foldless {

/// The most physical memory that a child of this process holds while it does the work, in bytes, what it shares with
/// this process included. Call it before any thread is started: the child has none but its own.
/// \throws std::runtime_error if there is no child, or it fails.
[[nodiscard]] std::size_t peak_memory_of(const std::function<void()>& work);

} // namespace foldless
