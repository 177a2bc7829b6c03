/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

#include <tbb/stand_in.h>

#include <cstddef>

namespace tbb {

/// What a process may have: nobody asks for less here.
class global_control {
public:
    enum parameter { max_allowed_parallelism };

    static std::size_t active_value(parameter /*of which there is one*/) { return stand_in::most_workers; }
};

} // namespace tbb
