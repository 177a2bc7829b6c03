/// \file
/// The inverse displacement problem by Newton's method: the alternative in use elsewhere, kept for comparison.
#pragma once

#include <foldless/predicates/inverse_displacement.h>

#include <optional>

namespace foldless {

/// One solution of q = sum alpha_i (v_i + t d_i), found by Newton's method from the centre of the triangle.
///
/// It solves (P(u,v) - q) x N(u,v) = 0 for the interpolated position P and direction N; the step is the least-squares
/// one, since there are three equations of rank two. At most 10 iterations, until a step is shorter than 1e-5. (Thonat
/// et al. 2023, "RMIP: Displacement ray tracing via inversion and oblong bounding", supplement, appendix B, eqs. 3 and
/// 4)
///
/// No value if it does not converge or a step has no solution. Which of several solutions is found, whether it is
/// inside the triangle, and whether there are others is unknown: use InverseDisplacement to decide anything.
[[nodiscard]] std::optional<Preimage> newton_inversion(const BaseTriangle& triangle, const Vec3& q);

} // namespace foldless
