/// \file
/// Base triangles with their directions, and points near them.
#pragma once

#include "byte_source.h"
#include "random_triangles.h"

#include <foldless/predicates/vector.h>

#include <cmath>
#include <cstddef>

namespace foldless::fuzz {

/// Directions that are above all parallel to the z axis; their special cases are those of a prismoid.
enum class Fan { free, equal, parallel, converging };
inline constexpr int fans = 4;

[[nodiscard]] inline Vec3 drawn_direction(ByteSource& bytes, Fan fan, Grain grain, const Vec3& corner) {
    switch (fan) {
    case Fan::free: return Vec3(0, 0, 1) + 0.25 * drawn_vector(bytes, grain);
    case Fan::equal: return {0.5, 0.25, 1};
    case Fan::parallel: return (1 + std::abs(bytes.fraction(64))) * Vec3(0.25, -0.5, 1);
    case Fan::converging: return (Vec3(0.25, 0.125, 4) - corner) * 0.5;
    }
    return Vec3::Zero();
}

/// A triangle near (0, 0), (1, 0), (0, 1) with directions near the z axis, in any unit of length.
[[nodiscard]] inline BaseTriangle drawn_triangle(ByteSource& bytes, Grain grain) {
    const Fan fan = static_cast<Fan>(bytes.below(fans));
    BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.v[i] += 0.125 * drawn_vector(bytes, grain);
        triangle.d[i] = drawn_direction(bytes, fan, grain, triangle.v[i]);
    }
    return triangle;
}

/// A range that holds 0, of quarters.
[[nodiscard]] inline Range drawn_range(ByteSource& bytes) {
    return {-0.25 * bytes.below(5), 0.25 * bytes.below(5)};
}

/// Parts of a triangle in eighths, its border and corners among them.
[[nodiscard]] inline Vec3 drawn_barycentric(ByteSource& bytes) {
    const int a = bytes.below(9);
    const int b = bytes.below(9 - a);
    return Vec3(a, b, 8 - a - b) / 8;
}

/// A point in, on the border of, or near the prismoid.
[[nodiscard]] inline Vec3 drawn_point(ByteSource& bytes, const BaseTriangle& triangle, Grain grain) {
    const Vec3 alpha = drawn_barycentric(bytes);
    const Vec3 point = displaced(triangle, alpha, bytes.fraction(64));
    switch (bytes.below(3)) {
    case 0: return point;
    case 1: return point.unaryExpr([&](double x) { return std::nextafter(x, x + bytes.below(3) - 1); });
    default: return point + 0.25 * drawn_vector(bytes, grain);
    }
}

} // namespace foldless::fuzz
