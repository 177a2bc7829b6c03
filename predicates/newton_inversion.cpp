#include <foldless/predicates/newton_inversion.h>

#include <Eigen/LU>

namespace foldless {
namespace {

// Both from Thonat et al. 2023, supplement, appendix B.
constexpr int iteration_limit = 10;
constexpr double shortest_step = 1e-5; // barycentric units

/// The point and direction at alpha = (1 - u - v, u, v), relative to q, with their derivatives.
struct Interpolant {
    Vec3 position_u, position_v, direction_u, direction_v;
    Vec3 position;
    Vec3 direction;

    void move(const Eigen::Vector2d& step) {
        position += step[0] * position_u + step[1] * position_v;
        direction += step[0] * direction_u + step[1] * direction_v;
    }
};

Interpolant interpolant_at_first_corner(const BaseTriangle& triangle, const Vec3& q) {
    return {triangle.v[1] - triangle.v[0],
            triangle.v[2] - triangle.v[0],
            triangle.d[1] - triangle.d[0],
            triangle.d[2] - triangle.d[0],
            triangle.v[0] - q,
            triangle.d[0]};
}

/// The Newton step of f = position x direction, by the normal equations (eq. 4, whose first derivative is misprinted as
/// one by v).
Eigen::Vector2d newton_step(const Interpolant& at) {
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian.col(0) = at.position_u.cross(at.direction) + at.position.cross(at.direction_u);
    jacobian.col(1) = at.position_v.cross(at.direction) + at.position.cross(at.direction_v);
    const Eigen::Matrix2d normal_matrix = jacobian.transpose() * jacobian;
    return -(normal_matrix.inverse() * (jacobian.transpose() * at.position.cross(at.direction)));
}

/// t and slope belong to the alpha that was reached.
Preimage preimage_at(const Interpolant& at, const Eigen::Vector2d& uv) {
    const double t = -at.position.dot(at.direction) / at.direction.squaredNorm();
    const Vec3 edge1 = at.position_u + t * at.direction_u;
    const Vec3 edge2 = at.position_v + t * at.direction_v;
    return {Vec3(1.0 - uv[0] - uv[1], uv[0], uv[1]), t, edge1.cross(edge2).dot(at.direction)};
}

} // namespace

std::optional<Preimage> newton_inversion(const BaseTriangle& triangle, const Vec3& q) {
    Interpolant at = interpolant_at_first_corner(triangle, q);
    Eigen::Vector2d uv = Eigen::Vector2d::Constant(1.0 / 3.0);
    at.move(uv);
    for (int iteration = 0; iteration < iteration_limit; ++iteration) {
        const Eigen::Vector2d step = newton_step(at);
        if (!step.allFinite()) {
            return std::nullopt;
        }
        uv += step;
        at.move(step);
        if (step.norm() < shortest_step) {
            return preimage_at(at, uv);
        }
    }
    return std::nullopt;
}

} // namespace foldless
