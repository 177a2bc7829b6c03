/// \file
/// The normal of a scan triangle and the condition N.n > 0 of Collins & Hilton 2002 (eq. 4): m(alpha) = d(alpha).n > 0,
/// where d(alpha) is the interpolated direction, of which only the sign of the product matters.
#pragma once

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <algorithm>
#include <limits>

namespace foldless {

/// n = (q1 - q0) x (q2 - q0), or that divided by a positive number, with a bound on its error. 32 bytes.
class ScanNormal {
public:
    explicit ScanNormal(const ScanTriangle& triangle)
        : ScanNormal(triangle[1] - triangle[0], triangle[2] - triangle[0]) {}

    /// Of no triangle: all signs undecided.
    [[nodiscard]] static ScanNormal none();

    /// The same divided by its length; all signs undecided if that is zero.
    [[nodiscard]] ScanNormal normalised() const;

    [[nodiscard]] const Vec3& value() const { return n_; }

    /// A bound on the error of d.dot(value()) as a stand-in for the exact d.n.
    [[nodiscard]] double error(const Vec3& d) const { return error_for(sum_norm(d)); }
    /// The same for all d whose components add up to this, by absolute value.
    [[nodiscard]] double error_for(double sum) const { return sum * dot_error_ + dot_underflow; }

    /// The sign of d.n from plain doubles and their error bound.
    [[nodiscard]] Sign seen_along(const Vec3& d) const { return sign_within(d.dot(n_), error(d)); }

    /// A normal of which d.dot(n) is off by at most sum_norm(d) dot_error, beside underflow.
    ScanNormal(const Vec3& n, double dot_error) : n_(n), dot_error_(dot_error) {}

private:
    // A component is the difference of two products of two differences: four roundings on at most 2 |e1| |e2| in all; 9
    // instead of 8 covers the second-order terms. Three products and two sums round the dot product by at most 3 units
    // of sum |d_k n_k|.
    ScanNormal(const Vec3& e1, const Vec3& e2)
        : n_(e1.cross(e2)),
          dot_error_(std::min(max_norm(e1), max_norm(e2)) >= least_length
                         ? 9 * unit_roundoff * max_norm(e1) * max_norm(e2) + 4 * unit_roundoff * max_norm(n_)
                         : std::numeric_limits<double>::infinity()) {}

    Vec3 n_;
    double dot_error_; ///< of a dot product, for each unit of the sum of |d_k|
};

/// The sign of d.n for the scan triangle, exactly: plain doubles first, then intervals, then exact numbers. Undecided
/// only if something is not finite.
[[nodiscard]] Sign seen_along(const Vec3& d, const ScanTriangle& triangle);

/// d(alpha) = sum alpha_i d_i with a bound on its error: one point of a base face, asked about many scan faces.
class InterpolatedDirection {
public:
    /// alpha is known up to `alpha_error` in each component.
    InterpolatedDirection(const std::array<Vec3, 3>& directions, const Vec3& alpha, double alpha_error);

    /// The sign of m(alpha) = d(alpha).n. (Collins & Hilton 2002, eq. 4)
    [[nodiscard]] Sign sees(const ScanNormal& normal) const {
        // (d + e).(n + f) - d.n = e.n + (d + e).f, and again e.f because the n at hand is n + f.
        const double error = normal.error_for(sum_) + component_error_ * sum_norm(normal.value()) + dot_underflow;
        return sign_within(d_.dot(normal.value()), error);
    }

private:
    Vec3 d_;
    double component_error_;
    double sum_; ///< of the components of d_ and of their errors, by absolute value
};

/// The sign of m(alpha) at one point for one scan face. (Collins & Hilton 2002, eq. 4)
[[nodiscard]] inline Sign normal_condition(const std::array<Vec3, 3>& directions, const Vec3& alpha, double alpha_error,
                                           const ScanNormal& normal) {
    return InterpolatedDirection(directions, alpha, alpha_error).sees(normal);
}

} // namespace foldless
