/// \file
/// All places of one point on the base mesh.
#pragma once

#include <foldless/verify/place.h>
#include <foldless/verify/prismoid_index.h>

#include <vector>

namespace foldless::verification {

/// Every place of one point.
struct Located {
    std::vector<Place> places; ///< in ascending order of faces, each point of a wall or pillar once
    /// The point is on a wall, but not in the range of the face across it, or there is no moving face: a place that
    /// does not count.
    bool on_open_wall = false;
};

/// All places of q within the ranges, exactly. Refers to q.
[[nodiscard]] Located locate(const BaseFaces& base, const PrismoidIndex& index, const Vec3& q);

/// Whether two faces share a vertex.
[[nodiscard]] bool are_adjacent(const BaseFaces& base, std::int32_t a, std::int32_t b);

} // namespace foldless::verification
