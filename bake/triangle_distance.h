/// \file
/// The point of a triangle that is nearest to a given point.
#pragma once

#include <foldless/predicates/vector.h>

namespace foldless::distances {

/// A point of a triangle and how far it is from what was asked for.
struct NearestPoint {
    Vec3 point;
    double squared_distance;
};

/// The point of the triangle nearest to `query`. The distance is right to within 2^-46 of the longest side of the box
/// around the four points, whatever the shape of the triangle: a segment or a point will do. The point is rounded to
/// its coordinates on top. \pre no coordinate is above 2^500
[[nodiscard]] NearestPoint nearest_point(const Vec3& query, const ScanTriangle& triangle);

} // namespace foldless::distances
