#include <foldless/decimate/prismoid.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// Relative slack of brackets and planes: far above their rounding (1e-15), far below the size of a face, so that
/// culling is safe and still sharp.
constexpr double cull_slack = 1e-9;

/// Along the wall opposite corner k, half way between the directions of its two ends.
Vec3 outward_of(const BaseTriangle& triangle, int k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    return (triangle.v[j] - triangle.v[i]).cross(triangle.d[i] + triangle.d[j]);
}

} // namespace

Prismoid::Prismoid(const BaseTriangle& triangle, Range range)
    : range_(range), inverse_(triangle), origin_(triangle.v[0]) {
    const Vec3 e1 = triangle.v[1] - triangle.v[0];
    const Vec3 e2 = triangle.v[2] - triangle.v[0];
    normal_ = e1.cross(e2);
    const std::array<double, 3> speed{triangle.d[0].dot(normal_), triangle.d[1].dot(normal_),
                                      triangle.d[2].dot(normal_)};
    per_height_ = 1 / *std::max_element(speed.begin(), speed.end());
    per_height_at_most_ = 1 / *std::min_element(speed.begin(), speed.end());
    unit_ = std::max(max_norm(e1), max_norm(e2)) / max_norm(triangle.d[0]);
    for (int k = 0; k < 3; ++k) {
        Plane& plane = planes_[k];
        plane.outward = outward_of(triangle, k);
        plane.level = Vec3(0, plane.outward.dot(e1), plane.outward.dot(e2));
        plane.drift =
            Vec3(plane.outward.dot(triangle.d[0]), plane.outward.dot(triangle.d[1]), plane.outward.dot(triangle.d[2]));
        plane.slack = cull_slack * sum_norm(plane.outward) * (sum_norm(e1) + sum_norm(e2));
    }
}

std::optional<Range> Prismoid::displacements(const Vec3& q) const {
    if (!(per_height_at_most_ > 0) || !(per_height_ > 0)) {
        return range_;
    }
    const Vec3 p = q - origin_;
    const double height = p.dot(normal_);
    double lo = height * (height >= 0 ? per_height_ : per_height_at_most_);
    double hi = height * (height >= 0 ? per_height_at_most_ : per_height_);
    const double widen = cull_slack * (std::abs(lo) + std::abs(hi) + unit_);
    lo = std::max(lo, range_.lo) - widen;
    hi = std::min(hi, range_.hi) + widen;
    if (lo > hi) {
        return std::nullopt;
    }
    for (const Plane& plane : planes_) {
        double furthest = -std::numeric_limits<double>::infinity();
        for (int c = 0; c < 3; ++c) {
            furthest = std::max(furthest, plane.level[c] + std::max(lo * plane.drift[c], hi * plane.drift[c]));
        }
        if (p.dot(plane.outward) > furthest + plane.slack) {
            return std::nullopt;
        }
    }
    return Range{lo, hi};
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
