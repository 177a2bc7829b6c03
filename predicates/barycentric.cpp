#include <foldless/predicates/barycentric.h>

#include <cmath>

namespace foldless {
namespace {

bool usable(double measure) {
    return measure != 0.0 && std::isfinite(measure);
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double volume(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c));
}

} // namespace

std::optional<Vec3> barycentric_in_plane(const Eigen::Vector2d& point, const std::array<Eigen::Vector2d, 3>& triangle) {
    const Eigen::Vector2d edge1 = triangle[1] - triangle[0];
    const Eigen::Vector2d edge2 = triangle[2] - triangle[0];
    const Eigen::Vector2d offset = point - triangle[0];
    const double area = cross(edge1, edge2);
    if (!usable(area)) {
        return std::nullopt;
    }
    const double beta = cross(offset, edge2) / area;
    const double gamma = cross(edge1, offset) / area;
    return Vec3(1.0 - beta - gamma, beta, gamma);
}

std::optional<Vec3> barycentric_in_triangle(const Vec3& point, const std::array<Vec3, 3>& triangle) {
    const Vec3 edge1 = triangle[1] - triangle[0];
    const Vec3 edge2 = triangle[2] - triangle[0];
    const Vec3 offset = point - triangle[0];
    const Vec3 normal = edge1.cross(edge2);
    const double square = normal.squaredNorm();
    if (!usable(square)) {
        return std::nullopt;
    }
    const double beta = normal.dot(offset.cross(edge2)) / square;
    const double gamma = normal.dot(edge1.cross(offset)) / square;
    return Vec3(1.0 - beta - gamma, beta, gamma);
}

std::optional<Eigen::Vector4d> barycentric_in_tetrahedron(const Vec3& point, const std::array<Vec3, 4>& tetrahedron) {
    const Vec3 edge1 = tetrahedron[1] - tetrahedron[0];
    const Vec3 edge2 = tetrahedron[2] - tetrahedron[0];
    const Vec3 edge3 = tetrahedron[3] - tetrahedron[0];
    const Vec3 offset = point - tetrahedron[0];
    const double whole = volume(edge1, edge2, edge3);
    if (!usable(whole)) {
        return std::nullopt;
    }
    const double beta = volume(offset, edge2, edge3) / whole;
    const double gamma = volume(edge1, offset, edge3) / whole;
    const double delta = volume(edge1, edge2, offset) / whole;
    return Eigen::Vector4d(1.0 - beta - gamma - delta, beta, gamma, delta);
}

} // namespace foldless
