#include <foldless/predicates/jacobian.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace foldless {
namespace {

/// Is b0 (1-x)^2 + 2 b1 x (1-x) + b2 x^2 positive for all x in [0, 1]? Exactly when b0 > 0, b2 > 0 and either b1 > 0 or
/// b1^2 < b0 b2: with both ends positive a minimum below zero needs b1 <= -sqrt(b0 b2).
template <class Number>
Sign positive_on_unit_interval(const Number& b0, const Number& twice_b1, const Number& b2) {
    const Sign ends[] = {sign_of(b0), sign_of(b2)};
    for (const Sign end : ends) {
        if (end == Sign::negative || end == Sign::zero) {
            return Sign::negative;
        }
    }
    if (ends[0] == Sign::undecided || ends[1] == Sign::undecided) {
        return Sign::undecided;
    }
    const Sign middle = sign_of(twice_b1);
    if (middle == Sign::positive || middle == Sign::zero) {
        return Sign::positive;
    }
    const Sign discriminant = sign_of(Number(4) * b0 * b2 - twice_b1 * twice_b1);
    if (discriminant == Sign::positive) {
        return Sign::positive;
    }
    const bool touches = discriminant == Sign::negative || discriminant == Sign::zero;
    return touches && middle == Sign::negative ? Sign::negative : Sign::undecided;
}

template <class Number>
struct Slice {
    VectorOf<Number> e1; ///< a_1 - a_0
    VectorOf<Number> e2; ///< a_2 - a_0

    Slice(const BaseTriangle& triangle, double t) {
        const auto corner = [&](int i) {
            return exactly<Number>(triangle.v[i]) + Number(t) * exactly<Number>(triangle.d[i]);
        };
        const VectorOf<Number> a0 = corner(0);
        e1 = corner(1) - a0;
        e2 = corner(2) - a0;
    }
};

/// All J_i by their Bernstein coefficients.
template <class Number>
Sign jacobian_in(const BaseTriangle& triangle, Range range) {
    const Slice<Number> lo(triangle, range.lo);
    const Slice<Number> hi(triangle, range.hi);
    const VectorOf<Number> n_lo = cross(lo.e1, lo.e2);
    const VectorOf<Number> n_hi = cross(hi.e1, hi.e2);
    const VectorOf<Number> twice_n_mixed = cross(lo.e1, hi.e2) + cross(hi.e1, lo.e2);
    Sign result = Sign::positive;
    for (const Vec3& direction : triangle.d) {
        const VectorOf<Number> d = exactly<Number>(direction);
        const Sign sign = positive_on_unit_interval(dot(d, n_lo), dot(d, twice_n_mixed), dot(d, n_hi));
        if (sign == Sign::negative) {
            return Sign::negative;
        }
        if (sign == Sign::undecided) {
            result = Sign::undecided;
        }
    }
    return result;
}

bool is_finite(const BaseTriangle& triangle) {
    const auto finite = [](const Vec3& v) { return v.allFinite(); };
    return std::all_of(triangle.v.begin(), triangle.v.end(), finite) &&
           std::all_of(triangle.d.begin(), triangle.d.end(), finite);
}

/// A quadratic c0 + c1 t + c2 t^2 in plain doubles.
struct Quadratic {
    double c0;
    double c1;
    double c2;
};

/// The root of the quadratic nearest to 0 on the positive side, or infinity; the quadratic is positive at 0.
double first_positive_root(const Quadratic& p) {
    const double none = std::numeric_limits<double>::infinity();
    const double discriminant = p.c1 * p.c1 - 4 * p.c0 * p.c2;
    if (discriminant < 0) {
        return none;
    }
    // Citardauq form: with c0 > 0 the roots are 2 c0 / (-c1 +- sqrt), and the smaller positive one has the larger
    // positive denominator.
    const double denominator = -p.c1 + std::sqrt(discriminant);
    return denominator > 0 ? 2 * p.c0 / denominator : none;
}

/// Whether all Bernstein coefficients are positive in plain doubles, beyond their rounding: nearly always.
bool clearly_positive_on(const BaseTriangle& triangle, Range range) {
    const Vec3 p1 = triangle.v[1] - triangle.v[0];
    const Vec3 p2 = triangle.v[2] - triangle.v[0];
    const Vec3 d1 = triangle.d[1] - triangle.d[0];
    const Vec3 d2 = triangle.d[2] - triangle.d[0];
    const Vec3 lo1 = p1 + range.lo * d1;
    const Vec3 lo2 = p2 + range.lo * d2;
    const Vec3 hi1 = p1 + range.hi * d1;
    const Vec3 hi2 = p2 + range.hi * d2;
    const Vec3 n_lo = lo1.cross(lo2);
    const Vec3 n_hi = hi1.cross(hi2);
    const Vec3 n_mixed = 0.5 * (lo1.cross(hi2) + hi1.cross(lo2));
    // An edge of a slice carries 3 roundings of its terms, a component of a cross product 8, the mixed one 9, a dot
    // product 12; 20 covers the second order.
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    const double size1 = max_norm(p1) + reach * max_norm(d1);
    const double size2 = max_norm(p2) + reach * max_norm(d2);
    const bool counted = std::min(size1, size2) >= least_length;
    return counted && std::all_of(triangle.d.begin(), triangle.d.end(), [&](const Vec3& d) {
               const double error = 20 * unit_roundoff * sum_norm(d) * 2 * size1 * size2;
               const auto is_positive = [&](const Vec3& n) { return sign_within(d.dot(n), error) == Sign::positive; };
               return sum_norm(d) >= least_length && is_positive(n_lo) && is_positive(n_mixed) && is_positive(n_hi);
           });
}

} // namespace

Sign jacobian_on(const BaseTriangle& triangle, Range range) {
    if (!(range.lo <= range.hi) || !std::isfinite(range.lo) || !std::isfinite(range.hi) || !is_finite(triangle)) {
        return Sign::negative;
    }
    if (filters_enabled() && clearly_positive_on(triangle, range)) {
        count_filtered();
        return Sign::positive;
    }
    return filtered([&](const auto& zero) { return jacobian_in<std::decay_t<decltype(zero)>>(triangle, range); });
}

Range fold_free_range(const BaseTriangle& triangle) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Vec3 p1 = triangle.v[1] - triangle.v[0];
    const Vec3 p2 = triangle.v[2] - triangle.v[0];
    const Vec3 d1 = triangle.d[1] - triangle.d[0];
    const Vec3 d2 = triangle.d[2] - triangle.d[0];
    const Vec3 pp = p1.cross(p2);
    const Vec3 pd = p1.cross(d2) + d1.cross(p2);
    const Vec3 dd = d1.cross(d2);
    Range range{-infinity, infinity};
    for (const Vec3& d : triangle.d) {
        const Quadratic j{d.dot(pp), d.dot(pd), d.dot(dd)};
        if (!(j.c0 > 0)) {
            return {infinity, -infinity};
        }
        range.hi = std::min(range.hi, first_positive_root(j));
        range.lo = std::max(range.lo, -first_positive_root({j.c0, -j.c1, j.c2}));
    }
    return range;
}

} // namespace foldless
