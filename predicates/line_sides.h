/// \file
/// The quadratics of a line and the walls of a base triangle in plain doubles. For the sources of this layer only.
#pragma once

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/vector.h>

#include <array>

namespace foldless {

/// side_k(t) = e.((a_i(t) - q) x (a_j(t) - q)) for a line from q along e, and w = N.e, which is the sum of the three:
/// coefficients in ascending order, and what bounds their rounding. (Lemma L5 of docs/certificate.md)
struct LineSides {
    /// Constant time. The inputs are finite.
    LineSides(const BaseTriangle& triangle, const ScanLine& line);

    using Quadratic = std::array<double, 3>;

    std::array<Quadratic, 3> sides; ///< zero where the line and the wall lie across an axis
    Quadratic rise;
    std::array<bool, 3> vanishes; ///< whether they do
    std::array<bool, 3> is_flat; ///< whether the directions of the wall are equal, so that the last coefficient is zero

    // The largest components of e, of the corners seen from q, and of the directions.
    double e_size, x_size, d_size;
    /// The coefficients of a side are off by this times x^2, 2 x d and d^2; those of w by four times as much. Infinite
    /// where products may underflow.
    double unit;
};

} // namespace foldless
