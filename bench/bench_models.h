/// \file
/// The generated models that whole runs are measured on.
#pragma once

#include <foldless/decimate/decimate.h>
#include <foldless/models/model.h>
#include <foldless/models/shape.h>

#include <array>
#include <cstdint>

namespace foldless {

/// Input faces asked for: each about twice the one before.
inline constexpr std::array<std::int64_t, 6> doubling_sizes{5'000, 10'000, 20'000, 40'000, 80'000, 160'000};

/// A shape of about so many faces, with the little noise of a good scanner: without it edges and angles tie.
[[nodiscard]] Model bench_model(Shape shape, std::int64_t faces);

/// The defaults, on one thread: processor time then depends on the work alone.
[[nodiscard]] DecimateOptions bench_options();

} // namespace foldless
