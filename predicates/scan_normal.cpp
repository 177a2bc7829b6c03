#include <foldless/predicates/scan_normal.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace foldless {
namespace {

/// Of a cross product of two edges of these sizes, a difference of two products of two differences: four roundings on
/// at most 2 |e1| |e2| in all; 9 instead of 8 covers the second-order terms.
double component_error(double e1, double e2) {
    return std::min(e1, e2) >= least_length ? 9 * unit_roundoff * e1 * e2 : std::numeric_limits<double>::infinity();
}

} // namespace

ScanNormal::ScanNormal(const Vec3& n, double component_error)
    // Three products and two sums round the dot product by at most 3 units of sum |d_k n_k|.
    : n_(n), dot_error_(component_error + 4 * unit_roundoff * max_norm(n)) {}

ScanNormal::ScanNormal(const ScanTriangle& triangle)
    : ScanNormal((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]),
                 component_error(max_norm(triangle[1] - triangle[0]), max_norm(triangle[2] - triangle[0]))) {}

ScanNormal ScanNormal::none() {
    return {Vec3::Zero(), std::numeric_limits<double>::infinity()};
}

ScanNormal ScanNormal::normalised() const {
    const double size = max_norm(n_);
    if (!(size > 0) || !std::isfinite(size)) {
        return none();
    }
    // A power of two, so that no square leaves the range of doubles; of all else it changes nothing.
    const int exponent = std::ilogb(size);
    const Vec3 scaled = n_.unaryExpr([&](double component) { return std::ldexp(component, -exponent); });
    const double length = scaled.norm();
    // One rounding in each quotient; what the bound holds beside the error of the components only adds to it.
    return {scaled / length, std::ldexp(dot_error_, -exponent) / length + unit_roundoff};
}

Sign seen_along(const Vec3& d, const ScanTriangle& triangle) {
    const Sign fast = filters_enabled() ? ScanNormal(triangle).seen_along(d) : Sign::undecided;
    if (fast != Sign::undecided) {
        count_filtered();
        return fast;
    }
    if (!d.allFinite() || !triangle[0].allFinite() || !triangle[1].allFinite() || !triangle[2].allFinite()) {
        return Sign::undecided;
    }
    return filtered([&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        return sign_of(dot(exactly<Number>(d), normal_of<Number>(triangle)));
    });
}

InterpolatedDirection::InterpolatedDirection(const std::array<Vec3, 3>& directions, const Vec3& alpha,
                                             double alpha_error)
    : d_(alpha[0] * directions[0] + alpha[1] * directions[1] + alpha[2] * directions[2]), component_error_(0) {
    // The products and the sums round by at most 3 units of |alpha_i d_i|; 4, and the factor, cover the second order.
    for (int i = 0; i < 3; ++i) {
        component_error_ += (alpha_error + 4 * unit_roundoff * std::abs(alpha[i])) * max_norm(directions[i]);
    }
    component_error_ *= 1 + 16 * unit_roundoff;
    sum_ = (1 + 16 * unit_roundoff) * (sum_norm(d_) + 3 * component_error_);
}

} // namespace foldless
