/// \file
/// Triangles without area, exactly.
#pragma once

#include <foldless/predicates/vector.h>

namespace foldless {

/// True if and only if the corners, taken as exact numbers, lie on one line. The coordinates must be finite.
[[nodiscard]] bool has_zero_area(const ScanTriangle& triangle);

} // namespace foldless
