/// \file
/// Where a point of the scan lies on the base mesh, exactly.
#pragma once

#include <foldless/verify/base_faces.h>

#include <foldless/predicates/prismoid_point.h>

#include <cstdint>

namespace foldless::verification {

/// The place of a scan vertex: inside or on a wall of a moving face, or on the pillar of a base vertex. A kept vertex
/// lies on the pillar of that vertex, at t = 0. A point on a wall is given in the lower of its two faces, which owns
/// it; one on a pillar in the lowest moving face around it.
struct Place {
    std::int32_t face = -1;
    PrismoidPoint at{};
    std::int32_t pillar = -1; ///< the base vertex, or -1

    [[nodiscard]] bool exists() const { return face >= 0; }
};

/// The base vertex on whose pillar a point of the face lies, or -1.
[[nodiscard]] std::int32_t pillar_of(const BaseFaces& base, std::int32_t face, Walls walls);

/// The number that wall k of the face has in the moving face across it. \pre that face exists
[[nodiscard]] int wall_across(const BaseFaces& base, std::int32_t face, int k);

/// The point on the pillar of a corner of a face.
[[nodiscard]] PrismoidPoint on_pillar(const BaseFaces& base, std::int32_t face, std::int32_t vertex,
                                      const Displacement& t);

/// t |d(alpha)| of the place of q, model units.
[[nodiscard]] double displacement(const BaseFaces& base, const Place& place, const Vec3& q);

} // namespace foldless::verification
