#include <foldless/decimate/vertex_directions.h>

#include <foldless/io/float32.h>

#include <cmath>

namespace foldless {

Vec3 stored_direction(const Vec3& direction) {
    return to_float32(direction.normalized());
}

std::optional<Vec3> vertex_normal(std::span<const std::array<Vec3, 3>> around, Directions weighting) {
    Vec3 sum = Vec3::Zero();
    for (const std::array<Vec3, 3>& triangle : around) {
        const Vec3 e1 = triangle[1] - triangle[0];
        const Vec3 e2 = triangle[2] - triangle[0];
        const Vec3 normal = e1.cross(e2);
        const double length = normal.norm();
        if (weighting == Directions::area) {
            sum += normal;
        } else if (length > 0) {
            sum += normal * (std::atan2(length, e1.dot(e2)) / length);
        }
    }
    const double length = sum.norm();
    return length > 0 && std::isfinite(length) ? std::optional<Vec3>(sum / length) : std::nullopt;
}

} // namespace foldless
