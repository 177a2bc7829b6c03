/// \file
/// foldless_bench_inversion: nanoseconds for one inverse displacement, by each way to find it.

#include <foldless/bench/inversion_cases.h>
#include <foldless/decimate/prismoid.h>
#include <foldless/predicates/batch_inversion.h>
#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/newton_inversion.h>

#include <benchmark/benchmark.h>

#include <bit>

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

/// Batches with what is prepared of their triangles.
struct PreparedBatch {
    Prismoid prismoid;
    PointBatch points;
};

std::vector<PreparedBatch> prepared_batches(PointBatch BatchCase::*points) {
    std::vector<PreparedBatch> list;
    for (const BatchCase& c : batch_cases()) {
        list.push_back({Prismoid(c.triangle, bench_range), c.*points});
    }
    return list;
}

/// Measures batch after batch; `s/point` is the time for one point.
template <class Ask>
void measure_batches(benchmark::State& state, PointBatch BatchCase::*points, Ask ask) {
    const std::vector<PreparedBatch> batches = prepared_batches(points);
    std::size_t i = 0;
    for ([[maybe_unused]] auto step : state) {
        ask(batches[i]);
        i = (i + 1) % case_count;
    }
    state.counters["s/point"] = benchmark::Counter(PointBatch::capacity, benchmark::Counter::kIsIterationInvariantRate |
                                                                             benchmark::Counter::kInvert);
}

void one_by_one(benchmark::State& state, PointBatch BatchCase::*points) {
    measure_batches(state, points, [](const PreparedBatch& batch) {
        for (int k = 0; k < batch.points.size; ++k) {
            benchmark::DoNotOptimize(batch.prismoid.inverse().preimages(batch.points.point(k), batch.points.range(k)));
        }
    });
}
BENCHMARK_CAPTURE(one_by_one, inside, &BatchCase::inside);
BENCHMARK_CAPTURE(one_by_one, bracketed, &BatchCase::bracketed);
BENCHMARK_CAPTURE(one_by_one, mixed, &BatchCase::mixed);

void in_batches(benchmark::State& state, PointBatch BatchCase::*points, InstructionSet set) {
    if (!is_available(set)) {
        return state.SkipWithError("not available");
    }
    measure_batches(state, points, [set](const PreparedBatch& batch) {
        const BatchInversion answers(batch.prismoid.inverse(), batch.points, set);
        for (unsigned left = answers.candidates(); left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            if ((answers.single() >> k & 1U) != 0) {
                benchmark::DoNotOptimize(answers.preimage(k));
            } else {
                benchmark::DoNotOptimize(answers.preimages(k));
            }
        }
    });
}
BENCHMARK_CAPTURE(in_batches, inside_scalar, &BatchCase::inside, InstructionSet::scalar);
BENCHMARK_CAPTURE(in_batches, inside_avx2, &BatchCase::inside, InstructionSet::avx2);
BENCHMARK_CAPTURE(in_batches, inside_avx512, &BatchCase::inside, InstructionSet::avx512);
BENCHMARK_CAPTURE(in_batches, bracketed_scalar, &BatchCase::bracketed, InstructionSet::scalar);
BENCHMARK_CAPTURE(in_batches, bracketed_avx2, &BatchCase::bracketed, InstructionSet::avx2);
BENCHMARK_CAPTURE(in_batches, bracketed_avx512, &BatchCase::bracketed, InstructionSet::avx512);
BENCHMARK_CAPTURE(in_batches, mixed_scalar, &BatchCase::mixed, InstructionSet::scalar);
BENCHMARK_CAPTURE(in_batches, mixed_avx2, &BatchCase::mixed, InstructionSet::avx2);
BENCHMARK_CAPTURE(in_batches, mixed_avx512, &BatchCase::mixed, InstructionSet::avx512);

/// The cull before it: the parts of the range in which the points of a batch may be reached.
void cull(benchmark::State& state, InstructionSet set) {
    if (!is_available(set)) {
        return state.SkipWithError("not available");
    }
    measure_batches(state, &BatchCase::mixed, [set](const PreparedBatch& batch) {
        PointBatch points = batch.points;
        benchmark::DoNotOptimize(batch.prismoid.displacements(points, set));
    });
}
BENCHMARK_CAPTURE(cull, scalar, InstructionSet::scalar);
BENCHMARK_CAPTURE(cull, avx2, InstructionSet::avx2);
BENCHMARK_CAPTURE(cull, avx512, InstructionSet::avx512);

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
