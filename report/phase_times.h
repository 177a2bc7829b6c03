/// \file
/// How long the phases of a run took.
#pragma once

#include <chrono>

namespace foldless {

/// Seconds on the clock and seconds of processor time of all threads.
struct PhaseTime {
    double seconds = 0.0;
    double cpu_seconds = 0.0;
    PhaseTime& operator+=(const PhaseTime& other);
};

struct PhaseTimes {
    PhaseTime read{};
    PhaseTime setup{};
    PhaseTime decimate{};
    PhaseTime verify{};
    PhaseTime write{};
    PhaseTime repair{};
    PhaseTime fit{};
    PhaseTime bake{};
    PhaseTime reconstruct{};
    PhaseTime compare{};
};

/// Measures from its construction, or from the last lap.
class Stopwatch {
public:
    Stopwatch();
    /// The time since the start of this lap; starts the next one.
    PhaseTime lap();

private:
    std::chrono::steady_clock::time_point start_;
    double cpu_start_; ///< processor time of the process, seconds
};

} // namespace foldless
