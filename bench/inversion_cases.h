/// \file
/// Base triangles with points above and below them, for measuring what is asked of one triangle.
#pragma once

#include <foldless/predicates/batch_inversion.h>
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

/// Points of one base triangle, as a patch has them.
struct BatchCase {
    BaseTriangle triangle;
    PointBatch inside;    ///< all are reached from the triangle in bench_range
    PointBatch bracketed; ///< the same, each in the part of the range that the decimator asks for
    PointBatch mixed;     ///< about half are not: beyond a wall, or beyond the range
};

/// `case_count` batches, eight in a row in one triangle.
[[nodiscard]] std::vector<BatchCase> batch_cases();

/// A scan edge that leaves the prismoid of a base triangle by the wall opposite corner 0.
struct WallCase {
    BaseTriangle triangle;
    Vec3 a; ///< start of the edge, inside
    Vec3 e; ///< from its start to its end, outside
};

[[nodiscard]] std::vector<WallCase> wall_cases();

} // namespace foldless
