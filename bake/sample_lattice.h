/// \file
/// Where the samples of a base face lie.
#pragma once

#include <foldless/predicates/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace foldless {

/// Samples at alpha_1 = i / columns, alpha_2 = j / rows, alpha_0 = 1 - alpha_1 - alpha_2 of a triangle. Both kinds of
/// maps are lattices: 2^L by 2^L in a micro-map of level L, the texels on the legs of a chart in an atlas.
///
///       j = rows  o
///                 | \            the samples inside are those with i / columns + j / rows <= 1,
///                 o   o          which integers decide
///                 |     \                                                                                         .
///           j = 0 o---o---o
///             i = 0     i = columns
struct SampleLattice {
    int columns = 1; ///< >= 1, at most max_side
    int rows = 1;    ///< >= 1, at most max_side

    /// Weights of samples are products of two sides, and exact as doubles.
    static constexpr int max_side = 1 << 20;

    [[nodiscard]] bool contains(int i, int j) const {
        return i >= 0 && j >= 0 && std::int64_t{i} * rows + std::int64_t{j} * columns <= std::int64_t{columns} * rows;
    }
    /// The largest i of the samples in row j. \pre 0 <= j <= rows
    [[nodiscard]] int last_column(int j) const { return static_cast<int>(std::int64_t{rows - j} * columns / rows); }
    /// Integers in the ratio of the barycentric coordinates; their sum is columns * rows. Exact, outside too.
    [[nodiscard]] Vec3 weights(int i, int j) const {
        const double w1 = static_cast<double>(i) * rows;
        const double w2 = static_cast<double>(j) * columns;
        return {static_cast<double>(columns) * rows - w1 - w2, w1, w2};
    }
    /// The barycentric coordinates, rounded.
    [[nodiscard]] Vec3 alpha(int i, int j) const { return weights(i, j) / (static_cast<double>(columns) * rows); }
};

} // namespace foldless
