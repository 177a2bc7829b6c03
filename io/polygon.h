/// \file
/// Which polygons may be fanned into triangles.
#pragma once

#include <foldless/predicates/vector.h>

#include <span>

namespace foldless {

/// How far the corners of a planar polygon may lie from a common plane, and a corner inside the line through its
/// neighbours, relative to the distance of the farthest corner from the first. Files round coordinates to about six
/// digits of the whole model, so that the corners of a polygon that is a thousandth of the model keep three. What is
/// flatter than this looks the same however it is split; what is not needs its author's triangles.
inline constexpr double polygon_flatness = 1e-3;

/// True if a fan from the first corner covers the polygon as its author meant it: planar and convex within
/// polygon_flatness, wound once, and no triangle of the fan turned over. Polygons with a coordinate that is not finite
/// pass: they are refused for that. Time O(corners).
[[nodiscard]] bool is_convex_and_planar(std::span<const Vec3> corners);

} // namespace foldless
