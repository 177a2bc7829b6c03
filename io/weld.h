/// \file
/// Gives corners at the same position one index.
#pragma once

#include <foldless/predicates/vector.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

struct Welded {
    std::vector<Vec3> positions;       ///< in order of first appearance
    std::vector<std::int32_t> indices; ///< one per corner, into positions
};

/// Merges corners whose coordinates are equal as numbers, -0.0 and 0.0 among them, or are the same NaN; nothing that is
/// only near. At most 2^31 - 1 corners. Time O(n log n), whatever the positions.
[[nodiscard]] Welded weld(std::span<const Vec3> corners);

} // namespace foldless
