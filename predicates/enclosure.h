/// \file
/// A certified neighbourhood of an inverse displacement that is known approximately.
#pragma once

#include <foldless/predicates/vector.h>

#include <optional>

namespace foldless {

/// A point (alpha, t) of a base triangle, known within error bounds.
struct Enclosure {
    Vec3 alpha;         ///< barycentric coordinates
    double t;           ///< displacement
    double alpha_error; ///< bound on the error of each alpha_i
    double t_error;     ///< bound on the error of t
};

/// Proves that q has an inverse displacement near (`alpha`, `t`), which is polished first, and bounds its distance;
/// nothing if that cannot be proven, because the guess is poor or the triangle ill-conditioned there.
///
/// The system is sum alpha_i (v_i + t d_i) = q in the unknowns (alpha_1, alpha_2, t); alpha may lie outside the
/// triangle. The proof is Krawczyk's: a ball that the simplified Newton map sends into itself holds a root, by Brouwer.
/// About 50 ns.
[[nodiscard]] std::optional<Enclosure> enclose(const BaseTriangle& triangle, const Vec3& q, const Vec3& alpha,
                                               double t);

} // namespace foldless
