/// \file
/// The unit of every error bound, and the norms in which the bounds are stated.
#pragma once

#include <foldless/predicates/vector.h>

#include <limits>

namespace foldless {

/// Half the distance from 1 to the next double: |fl(x op y) - (x op y)| <= unit_roundoff |x op y|. All bounds of the
/// predicates are small multiples of it; they hold in rounding to nearest, without contraction of multiply-adds.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Products of up to three lengths that are not below this stay clear of underflow, even times the rounding. The bounds
/// do not count underflow, so what is smaller is left to exact arithmetic.
inline constexpr double least_length = 1e-90;

/// What a dot product may lose to underflow, and its error bound with it.
inline constexpr double dot_underflow = 8 * std::numeric_limits<double>::denorm_min();

/// The largest component, by absolute value.
[[nodiscard]] inline double max_norm(const Vec3& v) {
    return v.cwiseAbs().maxCoeff();
}

/// The sum of the absolute values of the components: |u.v| <= sum_norm(u) max_norm(v).
[[nodiscard]] inline double sum_norm(const Vec3& v) {
    return v.cwiseAbs().sum();
}

} // namespace foldless
