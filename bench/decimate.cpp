/// \file
/// foldless_bench_decimate: whole runs on models of doubling size, until every edge is refused.

#include <foldless/bench/bench_models.h>
#include <foldless/bench/slope_reporter.h>
#include <foldless/bench/unguarded_loop.h>

#include <benchmark/benchmark.h>

namespace foldless {
namespace {

using Counter = benchmark::Counter;

/// How often an inversion is asked for each vertex of the scan.
double retests_per_vertex(const DecimateResult& result) {
    return static_cast<double>(result.statistics.retested_vertices) /
           static_cast<double>(result.correspondence.t.size());
}

/// Processor time over that of the loop without validator down to the same number of faces.
double ratio_to_unguarded(const Scan& scan, DecimateOptions options, const DecimateResult& result) {
    options.target_faces = result.base.faces.size();
    const UnguardedResult unguarded = unguarded_decimate(scan, options);
    return (result.statistics.setup_cpu_seconds + result.statistics.decimate_cpu_seconds) /
           (unguarded.setup_cpu_seconds + unguarded.decimate_cpu_seconds);
}

void run(benchmark::State& state, Shape shape) {
    const Scan scan = to_scan(bench_model(shape, state.range(0)));
    const DecimateOptions options = bench_options();
    DecimateResult result;
    for ([[maybe_unused]] auto step : state) {
        result = decimate(scan, options);
    }
    const auto faces = static_cast<double>(scan.faces.size());
    state.SetComplexityN(static_cast<std::int64_t>(scan.faces.size()));
    // Shown as e.g. 63u: microseconds.
    state.counters["s/face"] = Counter(faces, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["retests/vertex"] = retests_per_vertex(result);
    state.counters["faces_out"] = static_cast<double>(result.base.faces.size());
    state.counters["over_unguarded"] = ratio_to_unguarded(scan, options, result);
}

void doubling(benchmark::internal::Benchmark* benchmark) {
    for (const std::int64_t faces : doubling_sizes) {
        benchmark->Arg(faces);
    }
    benchmark->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}

BENCHMARK_CAPTURE(run, bumpy_sphere, Shape::bumpy_sphere)->Apply(doubling);
BENCHMARK_CAPTURE(run, torus, Shape::torus)->Apply(doubling);

} // namespace
} // namespace foldless

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    foldless::SlopeReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
}
