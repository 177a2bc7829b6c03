/// \file
/// Error quadrics: the sum of squared distances to a set of planes.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <optional>
#include <vector>

namespace foldless {

/// x^T A x - 2 b^T x + c, the weighted squared distance of x to planes, relative to a fixed origin near the model
/// (Garland & Heckbert 1997).
class Quadric {
public:
    /// Adds the plane through p with the given normal, weighted by the square of its length.
    void add_plane(const Vec3& p, const Vec3& normal);
    Quadric& operator+=(const Quadric& other);

    /// The error at x.
    [[nodiscard]] double operator()(const Vec3& x) const;

    /// The sum of the weights: the error of a point that is one unit away from every plane.
    [[nodiscard]] double weight() const { return xx_ + yy_ + zz_; }

    /// The point of least error, if it is well determined.
    [[nodiscard]] std::optional<Vec3> minimiser() const;

private:
    double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
    Vec3 b_ = Vec3::Zero();
    double c_ = 0;
};

/// For each scan vertex the planes of the faces around it, weighted by twice their areas, relative to `origin`.
[[nodiscard]] std::vector<Quadric> vertex_quadrics(const Scan& scan, const Vec3& origin);

} // namespace foldless
