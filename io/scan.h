/// \file
/// The scan as flat arrays: no half-edges, no attributes.
#pragma once

#include <foldless/predicates/vector.h>

#include <array>
#include <cstdint>
#include <vector>

namespace foldless {

/// The three vertices of a face, in its orientation.
using Triangle = std::array<std::int32_t, 3>;

/// A triangle mesh as read from a file: vertices and faces keep their order, nothing is welded or dropped.
struct Scan {
    std::vector<Vec3> positions; ///< model units; exactly the numbers of the file
    std::vector<Triangle> faces; ///< indices into positions
    bool float32 = true;         ///< every coordinate is a float32 value
};

} // namespace foldless
