#include <foldless/predicates/line_past_edge.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// sum w_i u_i for a corner array u.
template <class Number>
VectorOf<Number> weighted(const std::array<Vec3, 3>& u, const Vec3& weights) {
    return Number(weights[0]) * exactly<Number>(u[0]) + Number(weights[1]) * exactly<Number>(u[1]) +
           Number(weights[2]) * exactly<Number>(u[2]);
}

double largest(const std::array<Vec3, 3>& u) {
    return std::max({max_norm(u[0]), max_norm(u[1]), max_norm(u[2])});
}

} // namespace

SampleLine::SampleLine(const BaseTriangle& triangle, const Vec3& weights) : triangle_(&triangle), weights_(weights) {
    const Vec3 alpha = weights / weights.sum();
    x_ = alpha[0] * triangle.v[0] + alpha[1] * triangle.v[1] + alpha[2] * triangle.v[2];
    d_ = alpha[0] * triangle.d[0] + alpha[1] * triangle.d[1] + alpha[2] * triangle.d[2];
    // A quotient, a product and two sums: four roundings of each term.
    const double roundings = 4.5 * unit_roundoff * sum_norm(alpha);
    x_error_ = roundings * largest(triangle.v);
    d_error_ = roundings * largest(triangle.d);
}

SampleLine::Side SampleLine::side(const Vec3& a, const Vec3& b) const {
    const Vec3 from_a = a - x_;
    const Vec3 from_b = b - x_;
    const double value = d_.dot(from_a.cross(from_b));
    // Each of the six products of the determinant is off by the error of one factor times the other two, as large as
    // they may be, and by at most ten roundings of its own and of the sums.
    const double error_a = x_error_ + unit_roundoff * max_norm(from_a);
    const double error_b = x_error_ + unit_roundoff * max_norm(from_b);
    const double size_a = max_norm(from_a) + error_a;
    const double size_b = max_norm(from_b) + error_b;
    const double size_d = max_norm(d_) + d_error_;
    const double error = 6.5 * (size_d * (size_a * error_b + error_a * size_b) + d_error_ * size_a * size_b) +
                         64 * unit_roundoff * size_d * size_a * size_b + least_length * least_length;
    const Sign sign = filters_enabled() ? sign_within(value, error) : Sign::undecided;
    if (sign != Sign::undecided) {
        return {sign, value};
    }
    const Sign exact = exact_side(a, b);
    const bool agrees = exact == Sign::positive ? value > 0 : exact == Sign::negative ? value < 0 : value == 0;
    if (agrees) {
        return {exact, value};
    }
    const double tiny = std::numeric_limits<double>::min();
    return {exact, exact == Sign::positive ? tiny : exact == Sign::negative ? -tiny : 0.0};
}

Sign SampleLine::exact_side(const Vec3& a, const Vec3& b) const {
    return filtered([&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const Number sum = Number(weights_[0]) + Number(weights_[1]) + Number(weights_[2]);
        const VectorOf<Number> x = weighted<Number>(triangle_->v, weights_);
        const VectorOf<Number> d = weighted<Number>(triangle_->d, weights_);
        return sign_of(dot(d, cross(sum * exactly<Number>(a) - x, sum * exactly<Number>(b) - x)));
    });
}

} // namespace foldless
