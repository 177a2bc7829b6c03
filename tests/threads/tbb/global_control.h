/// \file
/// Stands in for the header of oneTBB of this name: see stand_in.h.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

namespace tbb {

/// How many threads a loop may take: what the last of these says that lives. Those of one thread end in the order in
/// which they began.
class global_control {
public:
    enum parameter { max_allowed_parallelism };

    global_control(parameter /*of which there is one*/, std::size_t threads) : before_(value().exchange(threads)) {}
    ~global_control() { value() = before_; }
    global_control(const global_control&) = delete;
    global_control& operator=(const global_control&) = delete;

    static std::size_t allowed() { return value(); }

private:
    static std::atomic<std::size_t>& value() {
        static std::atomic<std::size_t> threads{std::thread::hardware_concurrency()};
        return threads;
    }

    std::size_t before_;
};

} // namespace tbb
