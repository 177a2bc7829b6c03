#include <foldless/decimate/quadric.h>

#include <Eigen/LU>

#include <cmath>
#include <utility>

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

VertexQuadrics::VertexQuadrics(const Scan& scan, const ScanTopology& topology, const Vec3& origin)
    : scan_(&scan), topology_(&topology), origin_(origin), index_(scan.positions.size(), -1) {
    merged_.reserve(scan.positions.size() / 2); // address space: each has two vertices or more
}

Quadric VertexQuadrics::operator[](std::int32_t v) const {
    return index_[v] < 0 ? of_scan_vertex(v) : merged_[index_[v]];
}

Quadric VertexQuadrics::of_scan_vertex(std::int32_t v) const {
    Quadric quadric;
    for (const std::int32_t f : topology_->faces_around(v)) {
        const Triangle& face = scan_->faces[f];
        const Vec3& p = scan_->positions[face[0]];
        const Vec3 normal = (scan_->positions[face[1]] - p).cross(scan_->positions[face[2]] - p);
        const double length = normal.norm();
        const Vec3 weighted = length > 0 ? Vec3(normal / std::sqrt(length)) : Vec3(Vec3::Zero());
        quadric.add_plane(p - origin_, weighted);
    }
    return quadric;
}

void VertexQuadrics::merge(std::int32_t stays, std::int32_t gone) {
    Quadric sum = (*this)[stays];
    sum += (*this)[gone];
    if (index_[gone] >= 0) {
        merged_.remove(index_[gone]);
        index_[gone] = -1;
    }
    if (index_[stays] >= 0) {
        merged_[index_[stays]] = sum;
    } else {
        index_[stays] = merged_.add(sum);
    }
    if (merged_.is_sparse()) {
        give_back_room();
    }
}

/// Looks at every vertex, each time that three quarters of the merged ones have gone.
void VertexQuadrics::give_back_room() {
    Pool<Quadric> dense;
    dense.reserve(merged_.size());
    for (std::int32_t& index : index_) {
        index = index < 0 ? -1 : dense.add(merged_[index]);
    }
    merged_ = std::move(dense);
}

} // namespace foldless
