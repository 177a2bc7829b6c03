/// \file
/// Displacement directions of base vertices.
#pragma once

#include <foldless/decimate/decimate.h>
#include <foldless/predicates/vector.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace foldless {

/// The direction of unit length as a file stores it: rounded to float32.
[[nodiscard]] Vec3 stored_direction(const Vec3& direction);

/// The normal at a vertex of a surface from the triangles around it, each with the vertex as its first corner: weighted
/// by area or by the angle at the vertex. Nothing if it vanishes.
[[nodiscard]] std::optional<Vec3> vertex_normal(std::span<const std::array<Vec3, 3>> around, Directions weighting);

} // namespace foldless
