#include "usage.h"

#include <ctime>
#include <fstream>
#include <string>

namespace {

double read_clock(clockid_t clock) {
    constexpr double nanosecond = 1e-9;
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + nanosecond * static_cast<double>(time.tv_nsec);
}

} // namespace

Instant now() {
    return {read_clock(CLOCK_PROCESS_CPUTIME_ID), read_clock(CLOCK_MONOTONIC)};
}

// Not getrusage: that would count what the process was before it became this program, too.
std::size_t peak_memory_bytes() {
    constexpr std::size_t bytes_per_kibibyte = 1024;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::size_t kibibytes = 0;
        if (word == "VmHWM:" && status >> kibibytes) {
            return kibibytes * bytes_per_kibibyte;
        }
    }
    return 0;
}
