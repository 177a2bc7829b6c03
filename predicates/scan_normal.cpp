#include <foldless/predicates/scan_normal.h>

#include <foldless/predicates/interval.h>
#include <foldless/predicates/rounding.h>

#include <cmath>

namespace foldless {
ScanNormal::ScanNormal(const ScanTriangle& triangle) {
    const Vec3 e1 = triangle[1] - triangle[0];
    const Vec3 e2 = triangle[2] - triangle[0];
    n_ = e1.cross(e2);
    // A component is a difference of two products of two differences: four roundings on at most 2 |e1| |e2| in all;
    // 9 instead of 8 covers the second-order terms.
    component_error_ = 9 * unit_roundoff * max_norm(e1) * max_norm(e2);
}

double ScanNormal::error(const Vec3& d) const {
    // Three products and two sums round the dot product by at most 3 units of sum |d_k n_k|.
    return sum_norm(d) * (component_error_ + 4 * unit_roundoff * max_norm(n_));
}

Sign ScanNormal::seen_along(const Vec3& d) const {
    return sign_within(d.dot(n_), error(d));
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
