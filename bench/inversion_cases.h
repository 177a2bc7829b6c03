/// \file
/// Base triangles with points above and below them, for measuring what is asked of one triangle.
#pragma once

#include <foldless/predicates/vector.h>

#include <cstddef>
#include <vector>

namespace foldless {

/// Enough cases that their branches cannot be learnt by heart, few enough to stay in the second-level cache.
inline constexpr std::size_t case_count = 1024;

/// A base triangle as a base mesh has them, and a point q that it reaches at (alpha, t).
struct InversionCase {
    BaseTriangle triangle;
    Vec3 alpha; ///< inside the triangle
    double t;   ///< in bench_range
    Vec3 q;
};

/// Displacements of the cases; the edges of their triangles are about 1.
inline constexpr Range bench_range{-0.3, 0.3};

/// `case_count` cases, the same ones in every run.
[[nodiscard]] std::vector<InversionCase> inversion_cases();

/// A scan edge that leaves the prismoid of a base triangle by the wall opposite corner 0.
struct WallCase {
    BaseTriangle triangle;
    Vec3 a; ///< start of the edge, inside
    Vec3 e; ///< from its start to its end, outside
};

[[nodiscard]] std::vector<WallCase> wall_cases();

} // namespace foldless
