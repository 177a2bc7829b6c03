/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

namespace tbb {

/// Threads of the standard library take over the arithmetic of the thread that starts them, as those of an arena do.
class task_arena {
public:
    template <class Body>
    auto execute(const Body& body) {
        return body();
    }
};

} // namespace tbb
