#include <foldless/predicates/scan_normal.h>

#include <foldless/predicates/interval.h>
#include <foldless/predicates/rounding.h>

#include <cmath>
#include <limits>

namespace foldless {

ScanNormal::ScanNormal(const Vec3& n, double component_error)
    // Three products and two sums round the dot product by at most 3 units of sum |d_k n_k|.
    : n_(n), dot_error_(component_error + 4 * unit_roundoff * max_norm(n)) {}

ScanNormal::ScanNormal(const ScanTriangle& triangle)
    : ScanNormal((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]),
                 // A component is a difference of two products of two differences: four roundings on at most
                 // 2 |e1| |e2| in all; 9 instead of 8 covers the second-order terms.
                 9 * unit_roundoff * max_norm(triangle[1] - triangle[0]) * max_norm(triangle[2] - triangle[0])) {}

ScanNormal ScanNormal::normalised() const {
    const double length = n_.norm();
    // One rounding in each quotient; what the bound holds beside the error of the components only adds to it.
    return length > 0 ? ScanNormal(n_ / length, dot_error_ / length + unit_roundoff)
                      : ScanNormal(Vec3::Zero(), std::numeric_limits<double>::infinity());
}

Sign seen_along(const Vec3& d, const ScanTriangle& triangle) {
    const Sign fast = ScanNormal(triangle).seen_along(d);
    if (fast != Sign::undecided) {
        return fast;
    }
    const UpwardRounding upward;
    const IntervalVec3 q0 = exactly(triangle[0]);
    return sign_of(dot(exactly(d), cross(exactly(triangle[1]) - q0, exactly(triangle[2]) - q0)));
}

Sign normal_condition(const std::array<Vec3, 3>& directions, const Vec3& alpha, double alpha_error,
                      const ScanNormal& normal) {
    double m = 0;
    double error = 0;
    for (int i = 0; i < 3; ++i) {
        const double m_i = directions[i].dot(normal.value());
        m += alpha[i] * m_i;
        // The product and the sums round by at most 3 units of |alpha_i m_i|.
        error += std::abs(alpha[i]) * normal.error(directions[i]) +
                 (alpha_error + 4 * unit_roundoff * std::abs(alpha[i])) * (std::abs(m_i) + normal.error(directions[i]));
    }
    return sign_within(m, error);
}

} // namespace foldless
