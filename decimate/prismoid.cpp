#include <foldless/decimate/prismoid.h>

#include <foldless/decimate/prismoid_kernel.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {

#if defined(__x86_64__)
namespace avx2_lanes {
unsigned cull(const Prismoid::Bounds& bounds, PointBatch& points);
}
namespace avx512_lanes {
unsigned cull(const Prismoid::Bounds& bounds, PointBatch& points);
}
#endif

namespace {

/// Along the wall opposite corner k, half way between the directions of its two ends.
Vec3 outward_of(const BaseTriangle& triangle, int k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    return (triangle.v[j] - triangle.v[i]).cross(triangle.d[i] + triangle.d[j]);
}

} // namespace

Prismoid::Prismoid(const BaseTriangle& triangle, Range range) : inverse_(triangle) {
    bounds_.range = range;
    bounds_.origin = triangle.v[0];
    const Vec3 e1 = triangle.v[1] - triangle.v[0];
    const Vec3 e2 = triangle.v[2] - triangle.v[0];
    bounds_.normal = e1.cross(e2);
    const std::array<double, 3> speed{triangle.d[0].dot(bounds_.normal), triangle.d[1].dot(bounds_.normal),
                                      triangle.d[2].dot(bounds_.normal)};
    bounds_.per_height = 1 / *std::max_element(speed.begin(), speed.end());
    bounds_.per_height_at_most = 1 / *std::min_element(speed.begin(), speed.end());
    bounds_.unit = std::max(max_norm(e1), max_norm(e2)) / max_norm(triangle.d[0]);
    for (int k = 0; k < 3; ++k) {
        Plane& plane = bounds_.planes[k];
        plane.outward = outward_of(triangle, k);
        plane.level = Vec3(0, plane.outward.dot(e1), plane.outward.dot(e2));
        plane.drift =
            Vec3(plane.outward.dot(triangle.d[0]), plane.outward.dot(triangle.d[1]), plane.outward.dot(triangle.d[2]));
        plane.slack = Bounds::cull_slack * sum_norm(plane.outward) * (sum_norm(e1) + sum_norm(e2));
    }
}

std::optional<Range> Prismoid::displacements(const Vec3& q) const {
    if (!bounds_.has_brackets()) {
        return bounds_.range;
    }
    const scalar_lanes::LaneParts part = scalar_lanes::parts_of(bounds_, {q[0], q[1], q[2]});
    return part.none ? std::nullopt : std::optional(Range{part.lo, part.hi});
}

unsigned Prismoid::displacements(PointBatch& points, InstructionSet set) const {
    const unsigned every_point = (1U << points.size) - 1U;
    if (!bounds_.has_brackets()) {
        points.lo.fill(bounds_.range.lo);
        points.hi.fill(bounds_.range.hi);
        return every_point;
    }
    switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512: return every_point & ~avx512_lanes::cull(bounds_, points);
    case InstructionSet::avx2: return every_point & ~avx2_lanes::cull(bounds_, points);
#endif
    default: return every_point & ~scalar_lanes::cull_all(bounds_, points);
    }
}

WallPlanes::WallPlanes(const BaseTriangle& triangle, Range range) : origin_(triangle.v[0]) {
    std::array<std::array<Vec3, 2>, 3> ends; // of the pillars, seen from the origin
    double size = 0;
    for (int c = 0; c < 3; ++c) {
        ends[c] = {(triangle.v[c] - origin_) + range.lo * triangle.d[c],
                   (triangle.v[c] - origin_) + range.hi * triangle.d[c]};
        size = std::max({size, max_norm(ends[c][0]), max_norm(ends[c][1])});
    }
    for (int k = 0; k < 3; ++k) {
        outward_[k] = outward_of(triangle, k);
        // A wall is a family of segments between two pillars, so it lies in the hull of the four ends of these.
        double nearest = std::numeric_limits<double>::infinity();
        for (const int c : {(k + 1) % 3, (k + 2) % 3}) {
            nearest = std::min({nearest, outward_[k].dot(ends[c][0]), outward_[k].dot(ends[c][1])});
        }
        // Three roundings in an end, three in its dot product, four in that of a point of the prismoid, which is no
        // further away: 10 at most on either side, and 20 with room for the second order.
        level_[k] = nearest - 20 * unit_roundoff * sum_norm(outward_[k]) * size;
    }
}

} // namespace foldless
