/// \file
/// Which numbers float32 holds exactly.
#pragma once

#include <foldless/predicates/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace foldless {

/// The nearest float32 value; infinite beyond the largest.
[[nodiscard]] inline double to_float32(double value) {
    // A finite number beyond the largest float32 must not be converted: that is undefined.
    if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) {
        return std::copysign(std::numeric_limits<double>::infinity(), value);
    }
    // GCC 12 at -O2 drops the two conversions where it vectorises pairs of them; a volatile value cannot be dropped.
    const volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}

/// True if the number is a float32 value, infinities included; false for NaN.
[[nodiscard]] inline bool is_float32(double value) {
    return to_float32(value) == value;
}

/// The nearest float32 value that is not below; perhaps infinite.
[[nodiscard]] inline double float32_above(double value) {
    const double rounded = to_float32(value);
    return rounded >= value ? rounded
                            : std::nextafter(static_cast<float>(rounded), std::numeric_limits<float>::infinity());
}

/// The nearest float32 value that is not above; perhaps infinite.
[[nodiscard]] inline double float32_below(double value) {
    return -float32_above(-value);
}

/// True if all three coordinates are float32 values.
[[nodiscard]] inline bool is_float32(const Vec3& value) {
    return is_float32(value.x()) && is_float32(value.y()) && is_float32(value.z());
}

/// True if every coordinate is a float32 value.
[[nodiscard]] inline bool all_float32(const std::vector<Vec3>& values) {
    return std::ranges::all_of(values, [](const Vec3& value) { return is_float32(value); });
}

/// The nearest float32 values.
[[nodiscard]] inline Vec3 to_float32(const Vec3& value) {
    return {to_float32(value.x()), to_float32(value.y()), to_float32(value.z())};
}

} // namespace foldless
