#include <foldless/report/phase_times.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace foldless {

namespace {

constexpr std::chrono::milliseconds nap{50};
constexpr double nap_seconds = 0.05;

TEST(Stopwatch, MeasuresTheTimeOfTheLapAlone) {
    Stopwatch watch;
    std::this_thread::sleep_for(nap);
    const PhaseTime first = watch.lap();
    const PhaseTime second = watch.lap();
    EXPECT_GE(first.seconds, nap_seconds);
    EXPECT_LT(second.seconds, first.seconds);
}

TEST(Stopwatch, CountsNoProcessorTimeForASleep) {
    Stopwatch watch;
    std::this_thread::sleep_for(nap);
    EXPECT_LT(watch.lap().cpu_seconds, nap_seconds);
}

TEST(PhaseTime, AddsBothTimes) {
    PhaseTime time{1.0, 2.0};
    time += {0.5, 0.25};
    EXPECT_EQ(time.seconds, 1.5);
    EXPECT_EQ(time.cpu_seconds, 2.25);
}

} // namespace

} // namespace foldless
