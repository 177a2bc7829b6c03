/// \file
/// Prismoid::displacements() on the lanes of an instruction set.
#pragma once

#include <foldless/decimate/prismoid.h>
#include <foldless/predicates/lanes.h>

#include <limits>

namespace foldless::FOLDLESS_LANES {

/// Displacements of the solutions inside the triangle, for each lane.
struct LaneParts {
    Mask none; ///< there are none
    Real lo, hi;
};

/// Of a prismoid that has brackets.
FOLDLESS_INLINE LaneParts parts_of(const Prismoid::Bounds& bounds, const LaneVector& q) {
    const LaneVector p{q.x - all(bounds.origin[0]), q.y - all(bounds.origin[1]), q.z - all(bounds.origin[2])};
    const Real height = dot(p, bounds.normal);
    const Mask is_above = at_most(all(0.0), height);
    Real lo = height * select(is_above, all(bounds.per_height), all(bounds.per_height_at_most));
    Real hi = height * select(is_above, all(bounds.per_height_at_most), all(bounds.per_height));
    const Real widen = all(Prismoid::Bounds::cull_slack) * (absolute(lo) + absolute(hi) + all(bounds.unit));
    lo = greater_of(lo, all(bounds.range.lo)) - widen;
    hi = lesser_of(hi, all(bounds.range.hi)) + widen;
    Mask none = less(hi, lo);
    for (const Prismoid::Plane& plane : bounds.planes) {
        if (bits(none) == every_bit) {
            break;
        }
        Real furthest = all(-std::numeric_limits<double>::infinity());
        for (int c = 0; c < 3; ++c) {
            const Real drift = all(plane.drift[c]);
            furthest = greater_of(furthest, all(plane.level[c]) + greater_of(lo * drift, hi * drift));
        }
        none = either(none, less(furthest + all(plane.slack), dot(p, plane.outward)));
    }
    return {none, lo, hi};
}

/// Sets the ranges of the points. Bit k of the answer is set if point k certainly has no solution.
FOLDLESS_INLINE unsigned cull_all(const Prismoid::Bounds& bounds, PointBatch& points) {
    unsigned none = 0;
    for (int first = 0; first < points.size; first += lanes) {
        const LaneVector q{load(&points.x[first]), load(&points.y[first]), load(&points.z[first])};
        const LaneParts parts = parts_of(bounds, q);
        store(&points.lo[first], parts.lo);
        store(&points.hi[first], parts.hi);
        none |= bits(parts.none) << first;
    }
    return none;
}

} // namespace foldless::FOLDLESS_LANES
