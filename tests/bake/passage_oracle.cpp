#include "passage_oracle.h"

#include "exact_vector.h"

#include <algorithm>
#include <optional>

namespace foldless::oracle {
namespace {

using Rational = mpq_class;
using exact::Vector;

struct Line {
    Vector x;
    Vector d;
    Vec3 rounded_x;
    Vec3 rounded_d;
};

Rational ratio(std::int64_t numerator, std::int64_t denominator) {
    Rational result(static_cast<long>(numerator), static_cast<long>(denominator));
    result.canonicalize();
    return result;
}

Vec3 rounded(const Vector& v) {
    return {v.x.get_d(), v.y.get_d(), v.z.get_d()};
}

Line line_of(const BaseTriangle& triangle, const SampleLattice& lattice, int i, int j) {
    const Rational alpha1 = ratio(i, lattice.columns);
    const Rational alpha2 = ratio(j, lattice.rows);
    const auto at = [&](const std::array<Vec3, 3>& u) {
        const Vector first(u[0]);
        return first + alpha1 * (Vector(u[1]) - first) + alpha2 * (Vector(u[2]) - first);
    };
    const Vector x = at(triangle.v);
    const Vector d = at(triangle.d);
    return {x, d, rounded(x), rounded(d)};
}

/// Whether the line is so far from the triangle that doubles cannot err: a plane through the line and parallel to one
/// of two axes has all corners on one side.
bool is_far_off(const Line& line, const ScanTriangle& q) {
    const Vec3& d = line.rounded_d;
    const Vec3 across = std::abs(d.x()) < 0.5 * d.norm() ? d.cross(Vec3::UnitX()) : d.cross(Vec3::UnitY());
    for (const Vec3& normal : {across, Vec3(across.cross(d))}) {
        const auto [least, most] = std::minmax(
            {normal.dot(q[0] - line.rounded_x), normal.dot(q[1] - line.rounded_x), normal.dot(q[2] - line.rounded_x)});
        double size = line.rounded_x.norm();
        for (const Vec3& corner : q) {
            size = std::max(size, corner.norm());
        }
        constexpr double rounding = 1e-12;
        if (least > rounding * size * normal.norm() || most < -rounding * size * normal.norm()) {
            return true;
        }
    }
    return false;
}

std::optional<PassedFace> passed(const Line& line, const ScanTriangle& q, Range range) {
    if (is_far_off(line, q)) {
        return std::nullopt;
    }
    const Vector origin(q[0]);
    const Vector e1 = Vector(q[1]) - origin;
    const Vector e2 = Vector(q[2]) - origin;
    const Vector p = cross(line.d, e2);
    const Rational determinant = dot(e1, p);
    if (determinant >= 0) { // -d.n: from in front, or within the plane
        return std::nullopt;
    }
    const Vector s = line.x - origin;
    const Rational u = dot(s, p) / determinant;
    const Vector r = cross(s, e1);
    const Rational v = dot(line.d, r) / determinant;
    const Rational t = dot(e2, r) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || t < range.lo || t > range.hi) {
        return std::nullopt;
    }
    return PassedFace{-1, t.get_d(), u.get_d(), v.get_d()};
}

} // namespace

std::vector<PassedFace> passed_faces(const BaseTriangle& triangle, const SampleLattice& lattice, int i, int j,
                                     const Scan& scan, Range range) {
    const Line line = line_of(triangle, lattice, i, j);
    std::vector<PassedFace> result;
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(scan.faces.size()); ++face) {
        const auto& [a, b, c] = scan.faces[face];
        const ScanTriangle q{scan.positions[a], scan.positions[b], scan.positions[c]};
        if (std::optional<PassedFace> found = passed(line, q, range)) {
            found->face = face;
            result.push_back(*found);
        }
    }
    return result;
}

} // namespace foldless::oracle
