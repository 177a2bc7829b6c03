/// \file
/// Barycentric coordinates in triangles and tetrahedra.
#pragma once

#include <foldless/predicates/vector.h>

#include <array>
#include <optional>

namespace foldless {

// The coordinates are ratios of signed areas or volumes: their sum is 1, a corner has the coordinate 1 at itself, and a
// point is inside where none is negative. They are rounded. There is no value if the area or volume, as computed, is
// zero, or not finite. (Shaffer, "Barycentric coordinates", lecture notes; Ericson 2005, section 3.4)

/// The coordinates of `point` in a triangle of the plane; no value if its area is zero.
[[nodiscard]] std::optional<Vec3> barycentric_in_plane(const Eigen::Vector2d& point,
                                                       const std::array<Eigen::Vector2d, 3>& triangle);

/// The coordinates of the orthogonal projection of `point` to the plane of a triangle; no value if its area is zero.
[[nodiscard]] std::optional<Vec3> barycentric_in_triangle(const Vec3& point, const std::array<Vec3, 3>& triangle);

/// The coordinates of `point` in a tetrahedron of either orientation; no value if its volume is zero.
[[nodiscard]] std::optional<Eigen::Vector4d> barycentric_in_tetrahedron(const Vec3& point,
                                                                        const std::array<Vec3, 4>& tetrahedron);

} // namespace foldless
