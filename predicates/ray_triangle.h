/// \file
/// Intersection of a ray with a triangle.
#pragma once

#include <foldless/predicates/vector.h>

#include <optional>

namespace foldless {

/// The points origin + t direction; the direction has any length.
struct Ray {
    Vec3 origin;
    Vec3 direction;
};

/// The point origin + t direction = (1 - u - v) p0 + u p1 + v p2.
struct RayHit {
    double t;      ///< in units of the direction; negative behind the origin
    double u;      ///< barycentric coordinate of p1
    double v;      ///< barycentric coordinate of p2
    double facing; ///< direction . n with n = (p1 - p0) x (p2 - p0): > 0 where the ray leaves through the front
};

/// Where the line of `ray` meets `triangle`, border included, from either side and at any t, negative ones included: a
/// displacement may go inwards, and callers know their range. `facing` > 0 is the normal condition N . n > 0 of a
/// displacement map. No value if the line misses, or is parallel to the plane as computed; there is no other threshold.
///
/// Rounded: a hit near the border may be missed by both of two triangles that share it. (Moeller and Trumbore 1997,
/// "Fast, minimum storage ray-triangle intersection")
[[nodiscard]] std::optional<RayHit> intersection(const Ray& ray, const ScanTriangle& triangle);

} // namespace foldless
