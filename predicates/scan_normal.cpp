#include <foldless/predicates/scan_normal.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace foldless {

ScanNormal ScanNormal::none() {
    return {Vec3::Zero(), std::numeric_limits<double>::infinity()};
}

ScanNormal ScanNormal::normalised() const {
    const double size = max_norm(n_);
    if (!(size > 0) || !std::isfinite(size)) {
        return none();
    }
    // By a power of two, so that no square leaves the range of doubles; of all else it changes nothing.
    const bool has_squares = 0x1p-300 < size && size < 0x1p300;
    const int exponent = has_squares ? 0 : std::ilogb(size);
    const auto scaled = [&](double number) { return has_squares ? number : std::ldexp(number, -exponent); };
    const Vec3 n = n_.unaryExpr(scaled);
    const double inverse_length = 1 / n.norm();
    // Two roundings in each component, which is at most 1, and 4 in a dot product.
    return {n * inverse_length, scaled(dot_error_) * inverse_length + 7 * unit_roundoff};
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
