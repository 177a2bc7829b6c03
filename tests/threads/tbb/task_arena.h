/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

#include <tbb/stand_in.h>

#include <cstddef>
#include <utility>

namespace tbb {

/// Threads of the standard library take over the arithmetic of the thread that starts them, as those of an arena do.
class task_arena {
public:
    explicit task_arena(int threads) : threads_(static_cast<std::size_t>(threads)) {}

    template <class Body>
    auto execute(const Body& body) {
        const Allowance allowance(threads_);
        return body();
    }

private:
    /// Until it ends, the loops of this thread may take so many.
    class Allowance {
    public:
        explicit Allowance(std::size_t threads) : before_(std::exchange(stand_in::allowed, threads)) {}
        ~Allowance() { stand_in::allowed = before_; }
        Allowance(const Allowance&) = delete;
        Allowance& operator=(const Allowance&) = delete;

    private:
        std::size_t before_;
    };

    std::size_t threads_;
};

namespace this_task_arena {

/// More than current_thread_index() ever is.
inline int max_concurrency() {
    return stand_in::allowed == 1 ? 1 : 1 + static_cast<int>(stand_in::workers());
}

inline int current_thread_index() {
    return static_cast<int>(stand_in::worker);
}

} // namespace this_task_arena

} // namespace tbb
