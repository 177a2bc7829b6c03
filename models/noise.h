/// \file
/// Noise that depends on a seed and an index alone, whatever is asked in which order.
#pragma once

#include <array>
#include <cstdint>

namespace foldless {

/// Three independent numbers of mean 0 and variance 1, within [-2 sqrt(3), 2 sqrt(3)].
///
/// Each is the scaled sum of four uniform numbers (Irwin-Hall), drawn from the bits of a hash: close to a normal
/// distribution, but bounded, and made of exact arithmetic, so it is the same on every machine.
[[nodiscard]] std::array<double, 3> noise_at(std::uint64_t seed, std::uint64_t index);

} // namespace foldless
