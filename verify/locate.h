/// \file
/// All places of one point on the base mesh.
#pragma once

#include <foldless/verify/place.h>
#include <foldless/verify/prismoid_index.h>

#include <cstdint>
#include <vector>

namespace foldless::verification {

/// How many places a point has.
enum class Multiplicity : std::uint8_t {
    none,
    one, ///< one, or the same in the faces around a wall or pillar
    several,
    undecided, ///< rounding hides whether there is one
};

/// Every distinct place of one point, and their number.
struct Located {
    std::vector<Place> places;
    Multiplicity multiplicity = Multiplicity::none;
};

/// All places of q, grouped: what several faces hold of one point of a wall or pillar is one place. A place that
/// rounding leaves open makes the answer undecided if no place is certain, or a certain one is in a face that shares a
/// vertex with it; elsewhere it is left out: it would be ambiguous at most.
[[nodiscard]] Located locate(const BaseFaces& base, const PrismoidIndex& index, const Vec3& q);

/// Whether two faces share a vertex.
[[nodiscard]] bool are_adjacent(const BaseFaces& base, std::int32_t a, std::int32_t b);

} // namespace foldless::verification
