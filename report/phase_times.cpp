#include <foldless/report/phase_times.h>

#include <foldless/report/process_usage.h>

#include <utility>

namespace foldless {

PhaseTime& PhaseTime::operator+=(const PhaseTime& other) {
    seconds += other.seconds;
    cpu_seconds += other.cpu_seconds;
    return *this;
}

Stopwatch::Stopwatch() : start_(std::chrono::steady_clock::now()), cpu_start_(process_cpu_seconds()) {}

PhaseTime Stopwatch::lap() {
    const Stopwatch now;
    const Stopwatch then = std::exchange(*this, now);
    return {std::chrono::duration<double>(now.start_ - then.start_).count(), now.cpu_start_ - then.cpu_start_};
}

} // namespace foldless
