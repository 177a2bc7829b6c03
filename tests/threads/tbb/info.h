/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

#include <thread>

namespace tbb::info {

inline int default_concurrency() {
    return static_cast<int>(std::thread::hardware_concurrency());
}

} // namespace tbb::info
