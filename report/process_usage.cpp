#include <foldless/report/process_usage.h>

#include <sys/resource.h>

#include <ctime>
#include <fstream>
#include <limits>
#include <string>

namespace foldless {

namespace {

constexpr std::size_t bytes_per_kibibyte = 1024;
constexpr double seconds_per_nanosecond = 1e-9;

/// The line "VmHWM:  1234 kB" of the status that Linux keeps; 0 if there is none.
std::size_t peak_of_status_file() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::size_t kibibytes = 0;
        if (word == "VmHWM:" && status >> kibibytes) {
            return kibibytes * bytes_per_kibibyte;
        }
        status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0;
}

} // namespace

double process_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + seconds_per_nanosecond * static_cast<double>(time.tv_nsec);
}

std::size_t peak_memory_bytes() {
    // getrusage counts what the process held before exec, too: a small program that a large one starts would report
    // the memory of its parent. The status file starts afresh.
    if (const std::size_t peak = peak_of_status_file(); peak > 0) {
        return peak;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * bytes_per_kibibyte;
}

} // namespace foldless
