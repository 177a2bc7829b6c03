#include <foldless/bench/slope_reporter.h>

#include <fmt/format.h>

#include <unistd.h>

#include <cmath>

namespace foldless {

SlopeReporter::SlopeReporter() : ConsoleReporter(isatty(STDOUT_FILENO) != 0 ? OO_ColorTabular : OO_Tabular) {}

void SlopeReporter::ReportRuns(const std::vector<Run>& runs) {
    benchmark::ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type == Run::RT_Iteration && !run.error_occurred && run.complexity_n > 0) {
            points_[run.run_name.function_name].push_back(
                {std::log(static_cast<double>(run.complexity_n)), std::log(run.GetAdjustedCPUTime())});
        }
    }
}

void SlopeReporter::Finalize() {
    for (const auto& [name, points] : points_) {
        const double p = slope(points);
        if (std::isfinite(p)) {
            GetOutputStream() << fmt::format("{}: CPU time grows like size^{:.2f}\n", name, p);
        }
    }
    benchmark::ConsoleReporter::Finalize();
}

double SlopeReporter::slope(const std::vector<Point>& points) {
    const auto count = static_cast<double>(points.size());
    Point mean{0, 0};
    for (const Point& point : points) {
        mean.log_size += point.log_size / count;
        mean.log_time += point.log_time / count;
    }
    double product = 0;
    double square = 0;
    for (const Point& point : points) {
        const double x = point.log_size - mean.log_size;
        product += x * (point.log_time - mean.log_time);
        square += x * x;
    }
    return product / square; // not finite for a single size
}

} // namespace foldless
