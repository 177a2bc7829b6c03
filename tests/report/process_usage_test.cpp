#include <foldless/report/process_usage.h>

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace foldless {

namespace {

TEST(ProcessUsage, CpuSecondsGrowWithWork) {
    const double before = process_cpu_seconds();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (process_cpu_seconds() < before + 0.01 && std::chrono::steady_clock::now() < end) {
    }
    EXPECT_GE(process_cpu_seconds(), before + 0.01);
}

TEST(ProcessUsage, PeakMemoryKnowsOfMemoryThatWasTouched) {
    constexpr std::size_t size = std::size_t{64} << 20;
    const std::vector<char> touched(size, 'x');
    EXPECT_GE(peak_memory_bytes(), size);
    EXPECT_EQ(touched.back(), 'x');
}

} // namespace

} // namespace foldless
