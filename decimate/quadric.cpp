#include <foldless/decimate/quadric.h>

#include <Eigen/LU>

#include <cmath>

namespace foldless {
namespace {

/// A minimiser is used only if the determinant is at least this share of the largest possible one: flat and straight
/// parts of a surface leave it free to slide far away along them.
constexpr double least_relative_determinant = 1e-3;

} // namespace

void Quadric::add_plane(const Vec3& p, const Vec3& normal) {
    const double d = normal.dot(p);
    xx_ += normal.x() * normal.x();
    xy_ += normal.x() * normal.y();
    xz_ += normal.x() * normal.z();
    yy_ += normal.y() * normal.y();
    yz_ += normal.y() * normal.z();
    zz_ += normal.z() * normal.z();
    b_ += d * normal;
    c_ += d * d;
}

Quadric& Quadric::operator+=(const Quadric& other) {
    xx_ += other.xx_;
    xy_ += other.xy_;
    xz_ += other.xz_;
    yy_ += other.yy_;
    yz_ += other.yz_;
    zz_ += other.zz_;
    b_ += other.b_;
    c_ += other.c_;
    return *this;
}

double Quadric::operator()(const Vec3& x) const {
    const Vec3 ax(xx_ * x.x() + xy_ * x.y() + xz_ * x.z(), xy_ * x.x() + yy_ * x.y() + yz_ * x.z(),
                  xz_ * x.x() + yz_ * x.y() + zz_ * x.z());
    return x.dot(ax) - 2 * b_.dot(x) + c_;
}

std::optional<Vec3> Quadric::minimiser() const {
    Eigen::Matrix3d a;
    a << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
    const double third = a.trace() / 3;
    const double determinant = a.determinant();
    if (!(determinant > least_relative_determinant * third * third * third)) {
        return std::nullopt;
    }
    return Vec3(a.inverse() * b_);
}

std::vector<Quadric> vertex_quadrics(const Scan& scan, const Vec3& origin) {
    std::vector<Quadric> quadrics(scan.positions.size());
    for (const Triangle& face : scan.faces) {
        const Vec3& p = scan.positions[face[0]];
        const Vec3 normal = (scan.positions[face[1]] - p).cross(scan.positions[face[2]] - p);
        const double length = normal.norm();
        const Vec3 weighted = length > 0 ? Vec3(normal / std::sqrt(length)) : Vec3(Vec3::Zero());
        for (const std::int32_t v : face) {
            quadrics[v].add_plane(p - origin, weighted);
        }
    }
    return quadrics;
}

} // namespace foldless
