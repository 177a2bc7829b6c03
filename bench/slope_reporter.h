/// \file
/// The exponent with which time grows with size.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace foldless {

/// Reports runs as Google Benchmark does, and at the end, for each benchmark that sets its complexity N at two sizes at
/// least, the slope of log time over log N: the exponent p of time ~ N^p, by least squares.
class SlopeReporter : public benchmark::ConsoleReporter {
public:
    /// In colour on a terminal only.
    SlopeReporter();

    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

private:
    struct Point {
        double log_size;
        double log_time;
    };
    [[nodiscard]] static double slope(const std::vector<Point>& points);

    std::map<std::string, std::vector<Point>> points_; ///< by the name of the benchmark without its size
};

} // namespace foldless
