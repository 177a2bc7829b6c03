/// \file
/// foldless_bench_inversion: nanoseconds for one inverse displacement, by each way to find it.

#include <foldless/bench/inversion_cases.h>
#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/newton_inversion.h>

#include <benchmark/benchmark.h>

namespace foldless {
namespace {

const std::vector<InversionCase>& cases() {
    static const std::vector<InversionCase> made = inversion_cases();
    return made;
}

/// The triangles with their cached products.
const std::vector<InverseDisplacement>& prepared() {
    static const std::vector<InverseDisplacement> made = [] {
        std::vector<InverseDisplacement> list;
        for (const InversionCase& c : cases()) {
            list.emplace_back(c.triangle);
        }
        return list;
    }();
    return made;
}

/// Measures one answer at a time, and tells which share of the cases it finds.
template <class Ask, class Found>
void measure(benchmark::State& state, Ask ask, Found found) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < case_count; ++i) {
        count += found(ask(i)) ? 1 : 0;
    }
    std::size_t i = 0;
    for ([[maybe_unused]] auto step : state) {
        benchmark::DoNotOptimize(ask(i));
        i = (i + 1) % case_count;
    }
    state.counters["found"] = static_cast<double>(count) / static_cast<double>(case_count);
}

constexpr auto has_value = [](const auto& answer) { return answer.has_value(); };
constexpr auto is_not_empty = [](const Preimages& answer) { return !answer.empty(); };

void closed_form_prepare(benchmark::State& state) {
    measure(
        state, [](std::size_t i) { return InverseDisplacement(cases()[i].triangle); },
        [](const InverseDisplacement&) { return true; });
}
BENCHMARK(closed_form_prepare);

void closed_form_all(benchmark::State& state) {
    measure(
        state, [](std::size_t i) { return prepared()[i].preimages(cases()[i].q); }, is_not_empty);
}
BENCHMARK(closed_form_all);

void closed_form_in_range(benchmark::State& state) {
    measure(
        state, [](std::size_t i) { return prepared()[i].preimages(cases()[i].q, bench_range); }, is_not_empty);
}
BENCHMARK(closed_form_in_range);

void closed_form_nearest(benchmark::State& state) {
    measure(
        state, [](std::size_t i) { return prepared()[i].nearest(cases()[i].q); }, has_value);
}
BENCHMARK(closed_form_nearest);

void newton(benchmark::State& state) {
    measure(
        state, [](std::size_t i) { return newton_inversion(cases()[i].triangle, cases()[i].q); }, has_value);
}
BENCHMARK(newton);

void enclosure_of_known(benchmark::State& state) {
    measure(
        state,
        [](std::size_t i) {
            const InversionCase& c = cases()[i];
            return enclose(c.triangle, c.q, c.alpha, c.t);
        },
        has_value);
}
BENCHMARK(enclosure_of_known);

} // namespace
} // namespace foldless
