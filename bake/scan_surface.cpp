#include <foldless/bake/scan_surface.h>

#include <cmath>

namespace foldless {
namespace {

/// The angle between two vectors, 0 if one is zero.
double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::vector<Eigen::Vector3f> vertex_normals(const Scan& scan) {
    std::vector<Vec3> sums(scan.positions.size(), Vec3::Zero());
    for (const Triangle& face : scan.faces) {
        const std::array<Vec3, 3> q{scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
        const Vec3 normal = (q[1] - q[0]).cross(q[2] - q[0]).stableNormalized();
        for (int k = 0; k < 3; ++k) {
            sums[face[k]] += angle_between(q[(k + 1) % 3] - q[k], q[(k + 2) % 3] - q[k]) * normal;
        }
    }
    std::vector<Eigen::Vector3f> normals;
    normals.reserve(sums.size());
    for (const Vec3& sum : sums) {
        normals.push_back(sum.stableNormalized().cast<float>());
    }
    return normals;
}

} // namespace

ScanSurface::ScanSurface(const Scan& scan, const std::vector<Eigen::Vector3f>& vertex_colours)
    : scan_(&scan), colours_(&vertex_colours), normals_(vertex_normals(scan)) {}

ScanTriangle ScanSurface::triangle(std::int32_t face) const {
    const Triangle& corners = scan_->faces[face];
    return {scan_->positions[corners[0]], scan_->positions[corners[1]], scan_->positions[corners[2]]};
}

Eigen::Vector3f ScanSurface::normal(const ScanPoint& point) const {
    const Eigen::Vector3f sum = interpolated(normals_, point);
    const float length = sum.norm();
    if (length > 0.0F) {
        return sum / length;
    }
    const ScanTriangle q = triangle(point.face);
    return (q[1] - q[0]).cross(q[2] - q[0]).stableNormalized().cast<float>();
}

Eigen::Vector3f ScanSurface::colour(const ScanPoint& point) const {
    return interpolated(*colours_, point);
}

Eigen::Vector3f ScanSurface::interpolated(const std::vector<Eigen::Vector3f>& values, const ScanPoint& point) const {
    const Triangle& corners = scan_->faces[point.face];
    const auto u = static_cast<float>(point.u);
    const auto v = static_cast<float>(point.v);
    return (1.0F - u - v) * values[corners[0]] + u * values[corners[1]] + v * values[corners[2]];
}

} // namespace foldless
