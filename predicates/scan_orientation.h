/// \file
/// Which way round the image of a scan triangle lies in a base triangle.
#pragma once

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <array>

namespace foldless {

/// The barycentric coordinates in one base triangle of the three corners of a scan triangle, in its orientation.
using BarycentricTriangle = std::array<Vec3, 3>;

/// The orientation of the straight triangle alpha[0], alpha[1], alpha[2] in the base triangle: the sign of
///
///     (alpha_0^1 - alpha_0^0) (alpha_1^2 - alpha_1^0) - (alpha_0^2 - alpha_0^0) (alpha_1^1 - alpha_1^0),
///
/// superscript = scan corner, subscript = component; positive if it turns as the base triangle does. Exact for the
/// components 0 and 1 as given (the third is not read), if they are finite and their products do not underflow; never
/// undecided then. Maggiordomo et al. 2023, eq. 19, prints other indices, which is no cross product.
///
/// The image of a scan triangle has curved sides: this sign is a test of its corners, not a proof for its inside.
[[nodiscard]] Sign scan_orientation(const BarycentricTriangle& alpha);

/// The same for coordinates each of which is known with the absolute error `error[corner]` (>= 0). Undecided if another
/// sign is possible within the errors. Never zero unless the errors are.
[[nodiscard]] Sign scan_orientation(const BarycentricTriangle& alpha, const std::array<double, 3>& error);

/// A point of a prismoid, known by its displacement; a corner of the triangle is v_i with t = 0.
struct DisplacedPoint {
    Vec3 q;
    Displacement t;
};

/// The same for points with these displacements, which are roots of three different cubics: they are halved up to 256
/// times, and what is undecided then stays so. Zero only if all three are rational. \pre J > 0 at the displacements
[[nodiscard]] Sign scan_orientation(const BaseTriangle& triangle, const std::array<DisplacedPoint, 3>& points);

} // namespace foldless
