/// \file
/// The direction that sees a set of scan faces best.
#pragma once

#include <foldless/predicates/vector.h>

#include <optional>
#include <span>

namespace foldless {

/// The unit vector that maximises the smallest dot product with the given unit normals, if that is positive: the centre
/// of the smallest cap of the sphere that holds them. Nothing if no direction sees all of them. (Welzl-like pivoting:
/// the furthest normal enters the basis of at most three; linear time a step, a handful of steps.)
[[nodiscard]] std::optional<Vec3> most_visible_direction(std::span<const Vec3> unit_normals);

} // namespace foldless
