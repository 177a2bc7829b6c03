#include <foldless/io/polygon.h>

#include <algorithm>
#include <vector>

namespace foldless {

namespace {

/// The corners relative to the first one, scaled so that the farthest is at distance about 1: products neither overflow
/// nor underflow. Empty if all corners are one point.
std::vector<Vec3> normalised(std::span<const Vec3> corners) {
    double extent = 0.0;
    for (const Vec3& corner : corners) {
        extent = std::max(extent, (corner / 2 - corners[0] / 2).lpNorm<Eigen::Infinity>());
    }
    if (extent == 0.0) {
        return {};
    }
    std::vector<Vec3> local;
    local.reserve(corners.size());
    for (const Vec3& corner : corners) {
        local.emplace_back((corner / 2 - corners[0] / 2) / extent);
    }
    return local;
}

Vec3 area_vector(std::span<const Vec3> local) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < local.size(); ++i) {
        area += local[i].cross(local[i + 1]);
    }
    return area;
}

bool is_planar(std::span<const Vec3> local, const Vec3& normal, double tolerance) {
    double lowest = 0.0;
    double highest = 0.0;
    for (const Vec3& corner : local) {
        lowest = std::min(lowest, corner.dot(normal));
        highest = std::max(highest, corner.dot(normal));
    }
    return highest - lowest <= tolerance;
}

/// No triangle of the fan is turned over, and all corners lie to the left of the first edge: the rays of the fan sweep
/// at most half a turn, which a polygon wound twice would exceed.
bool fan_is_upright(std::span<const Vec3> local, const Vec3& normal) {
    for (std::size_t i = 1; i + 1 < local.size(); ++i) {
        if (local[i].cross(local[i + 1]).dot(normal) < 0.0 || local[1].cross(local[i + 1]).dot(normal) < 0.0) {
            return false;
        }
    }
    return true;
}

/// Every corner turns left, or lies inside the line through its neighbours by no more than the tolerance.
bool turns_left(std::span<const Vec3> local, const Vec3& normal, double tolerance) {
    const std::size_t n = local.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 before = local[i] - local[(i + n - 1) % n];
        const Vec3 chord = local[(i + 1) % n] - local[(i + n - 1) % n];
        if (before.cross(chord).dot(normal) < -tolerance * chord.norm()) {
            return false;
        }
    }
    return true;
}

} // namespace

bool is_convex_and_planar(std::span<const Vec3> corners) {
    if (!std::ranges::all_of(corners, [](const Vec3& corner) { return corner.allFinite(); })) {
        return true;
    }
    const std::vector<Vec3> local = normalised(corners);
    const Vec3 area = area_vector(local);
    if (local.empty() || area == Vec3::Zero()) {
        return false;
    }
    double extent = 0.0;
    for (const Vec3& corner : local) {
        extent = std::max(extent, corner.norm());
    }
    const Vec3 normal = area.normalized();
    const double tolerance = polygon_flatness * extent;
    return is_planar(local, normal, tolerance) && fan_is_upright(local, normal) && turns_left(local, normal, tolerance);
}

} // namespace foldless
