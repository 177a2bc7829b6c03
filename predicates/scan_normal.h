/// \file
/// The normal of a scan triangle and the condition N.n > 0 of Collins & Hilton 2002 (eq. 4): m(alpha) = d(alpha).n > 0,
/// where d(alpha) is the interpolated direction, of which only the sign of the product matters.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

namespace foldless {

/// n = (q1 - q0) x (q2 - q0), not normalised, with a bound on the error of each component.
class ScanNormal {
public:
    explicit ScanNormal(const ScanTriangle& triangle);

    [[nodiscard]] const Vec3& value() const { return n_; }

    /// A bound on the error of d.dot(value()) as a stand-in for the exact d.n.
    [[nodiscard]] double error(const Vec3& d) const;

    /// The sign of d.n from plain doubles and their error bound.
    [[nodiscard]] Sign seen_along(const Vec3& d) const;

private:
    Vec3 n_;
    double component_error_;
};

/// The sign of d.n for the scan triangle: plain doubles first, then intervals.
[[nodiscard]] Sign seen_along(const Vec3& d, const ScanTriangle& triangle);

/// The sign of m(alpha) = sum alpha_i d_i.n, with alpha known up to `alpha_error` in each component. (Collins & Hilton
/// 2002, eq. 4)
[[nodiscard]] Sign normal_condition(const std::array<Vec3, 3>& directions, const Vec3& alpha, double alpha_error,
                                    const ScanNormal& normal);

} // namespace foldless
