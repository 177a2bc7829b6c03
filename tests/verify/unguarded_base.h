/// \file
/// What makes the mesh of a decimator without displacements a base mesh.
#pragma once

#include <foldless/io/bounding_box.h>
#include <foldless/io/float32.h>

#include "made_meshes.h"
#include "random_scans.h"

namespace foldless::test {

/// Gives the mesh area-weighted normals for directions, and all its faces one range about 0, of a random size.
inline void add_displacements(BaseMesh& base, const Scan& scan, Random& random) {
    base.directions.assign(base.positions.size(), Vec3::Zero());
    const double size = uniform(random, 0.02, 0.3) * bounding_box_diagonal(scan);
    for (const Triangle& face : base.faces) {
        const Vec3& first = base.positions[face[0]];
        const Vec3 normal = (base.positions[face[1]] - first).cross(base.positions[face[2]] - first);
        for (const std::int32_t corner : face) {
            base.directions[corner] += normal;
        }
        base.ranges.push_back({float32_below(-size), float32_above(size)});
    }
    for (Vec3& direction : base.directions) {
        direction = to_float32(direction.normalized());
    }
}

} // namespace foldless::test
