#include <foldless/predicates/ray_triangle.h>

namespace foldless {

std::optional<RayHit> intersection(const Ray& ray, const ScanTriangle& triangle) {
    const Vec3 edge1 = triangle[1] - triangle[0];
    const Vec3 edge2 = triangle[2] - triangle[0];
    const Vec3 p = ray.direction.cross(edge2);
    const double determinant = edge1.dot(p);
    if (determinant == 0.0) {
        return std::nullopt;
    }
    const Vec3 offset = ray.origin - triangle[0];
    const Vec3 q = offset.cross(edge1);
    const double u = offset.dot(p) / determinant;
    const double v = ray.direction.dot(q) / determinant;
    // Written so that NaN misses.
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) {
        return std::nullopt;
    }
    return RayHit{edge2.dot(q) / determinant, u, v, -determinant};
}

} // namespace foldless
