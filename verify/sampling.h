/// \file
/// Points spread evenly over a triangle, the same in every run.
#pragma once

#include <foldless/predicates/vector.h>

#include <cstdint>

namespace foldless::verification {

/// Barycentric coordinates of point `i` of a low-discrepancy sequence in a triangle; `seed` shifts the sequence.
/// (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences": the R2 sequence, folded into the triangle)
[[nodiscard]] Vec3 low_discrepancy_point(std::uint64_t seed, int i);

/// Barycentric coordinates of a point inside subtriangle `i` of the side^2 congruent ones into which parallels to the
/// edges cut a triangle.
[[nodiscard]] Vec3 stratified_point(std::uint64_t seed, int side, int i);

} // namespace foldless::verification
