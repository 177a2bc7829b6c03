/// \file
/// Where on a base face a scan face can lie.
#pragma once

#include <foldless/predicates/vector.h>

#include <array>
#include <optional>

namespace foldless {

/// Bounds on the barycentric coordinates of points of a base face.
struct AlphaBox {
    std::array<double, 3> lo;
    std::array<double, 3> hi;
};

/// Bounds on alpha over all points with alpha_i >= 0 that are displaced onto the scan triangle, within the range and
/// with N.n > 0. Nothing if there are none. Margins cover the rounding. Constant time.
///
/// Two bounds narrow each other. A point is displaced into the plane of the triangle by t = -l / m, with l and m linear
/// in alpha (docs/certificate.md, Notation), which bounds t over a polygon by its corners. And for displacements near a
/// middle one alpha is nearly linear in the scan point: it is so in the slice, seen along the mean direction, and what
/// lies beside the slice moves by no more than the directions of the corners differ from the mean.
[[nodiscard]] std::optional<AlphaBox> image_box(const BaseTriangle& triangle, Range range, const ScanTriangle& scan);

} // namespace foldless
