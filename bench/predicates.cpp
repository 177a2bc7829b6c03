/// \file
/// foldless_bench_predicates: nanoseconds for one answer of the predicates that the validator asks most.

#include <foldless/bench/inversion_cases.h>
#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/prismoid_line.h>
#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/wall.h>

#include <benchmark/benchmark.h>

namespace foldless {
namespace {

constexpr int wall_opposite = 0; // the wall that the edges of the cases pass

/// Measures one answer at a time.
template <class Ask>
void measure(benchmark::State& state, Ask ask) {
    std::size_t i = 0;
    for ([[maybe_unused]] auto step : state) {
        benchmark::DoNotOptimize(ask(i));
        i = (i + 1) % case_count;
    }
}

/// As measure, and tells which share of the answers is not `undecided`.
template <class Ask>
void measure_sign(benchmark::State& state, Ask ask) {
    std::size_t decided = 0;
    for (std::size_t i = 0; i < case_count; ++i) {
        decided += ask(i) != Sign::undecided ? 1 : 0;
    }
    measure(state, ask);
    state.counters["decided"] = static_cast<double>(decided) / static_cast<double>(case_count);
}

std::vector<Wall> walls_of(const std::vector<WallCase>& cases) {
    std::vector<Wall> walls;
    for (const WallCase& c : cases) {
        walls.emplace_back(c.triangle, wall_opposite);
    }
    return walls;
}

void jacobian_on_range(benchmark::State& state) {
    const std::vector<InversionCase> cases = inversion_cases();
    measure_sign(state, [&](std::size_t i) { return jacobian_on(cases[i].triangle, bench_range); });
}
BENCHMARK(jacobian_on_range);

void wall_prepare(benchmark::State& state) {
    const std::vector<WallCase> cases = wall_cases();
    measure(state, [&](std::size_t i) { return Wall(cases[i].triangle, wall_opposite); });
}
BENCHMARK(wall_prepare);

void wall_passed_one_way(benchmark::State& state) {
    const std::vector<WallCase> cases = wall_cases();
    const std::vector<Wall> walls = walls_of(cases);
    measure(state, [&](std::size_t i) { return walls[i].is_passed_one_way(cases[i].e, bench_range); });
}
BENCHMARK(wall_passed_one_way);

void point_in_prismoid(benchmark::State& state) {
    const std::vector<InversionCase> cases = inversion_cases();
    std::vector<PointFinder> finders;
    for (const InversionCase& c : cases) {
        finders.emplace_back(c.triangle, bench_range);
    }
    measure(state, [&](std::size_t i) { return finders[i].find(cases[i].q); });
}
BENCHMARK(point_in_prismoid);

void line_in_prismoid(benchmark::State& state) {
    const std::vector<WallCase> cases = wall_cases();
    std::vector<Vec3> ends;
    std::vector<PrismoidPoint> starts;
    for (const WallCase& c : cases) {
        ends.emplace_back(c.a + c.e);
        starts.push_back(PointFinder(c.triangle, bench_range).find(c.a).value());
    }
    measure(state, [&](std::size_t i) {
        return follow_line(cases[i].triangle, {&cases[i].a, &ends[i]}, starts[i], nullptr).kind;
    });
}
BENCHMARK(line_in_prismoid);

} // namespace
} // namespace foldless
