/// \file
/// Where the line of a sample passes through a scan face.
#pragma once

#include <foldless/predicates/line_past_edge.h>
#include <foldless/predicates/vector.h>

#include <optional>

namespace foldless {

/// A point of a scan triangle on the line of a sample.
struct Piercing {
    Vec3 weights; ///< of the corners of the triangle, each at least 0, in all 1
    double t;     ///< along the line, in units of its direction
};

/// Where the line passes through the triangle from behind, its border included, so that N.n > 0. Nothing if it misses
/// it, passes from in front, or lies in its plane. What is decided is decided exactly; the numbers are rounded.
[[nodiscard]] std::optional<Piercing> piercing(const SampleLine& line, const ScanTriangle& triangle);

} // namespace foldless
