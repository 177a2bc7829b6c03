/// \file
/// J(alpha, t) = det(a_1 - a_0, a_2 - a_0, d(alpha)), the Jacobian of the displacement map of a base triangle. Where it
/// is positive on a whole prismoid T x [lo, hi], the map is injective there and every point has at most one inverse
/// displacement (docs/certificate.md).
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

namespace foldless {

/// Whether J > 0 on all of T x `range`: positive if so, negative if J <= 0 somewhere; never zero or undecided. Decided
/// by the Bernstein coefficients of the three quadratics J_i on the values as given, in doubles with a bound, in
/// intervals, or exactly. A range that is empty is negative, and so is whatever is not finite.
[[nodiscard]] Sign jacobian_on(const BaseTriangle& triangle, Range range);

/// An estimate, in plain doubles, of the largest range around t = 0 on which J > 0 at every corner. Infinite ends are
/// possible. Empty (lo > hi) if J(0) <= 0 at some corner. A hint for searches, never a proof.
[[nodiscard]] Range fold_free_range(const BaseTriangle& triangle);

} // namespace foldless
