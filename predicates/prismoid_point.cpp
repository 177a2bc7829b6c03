#include <foldless/predicates/prismoid_point.h>

#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/real_root.h>
#include <foldless/predicates/scan_normal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace foldless {
namespace {

/// The walls on which the root lies, or nothing if it is outside the triangle.
std::optional<Walls> walls_at(const BaseTriangle& triangle, const Vec3& q, const Displacement& t) {
    Walls walls = 0;
    for (int k = 0; k < 3; ++k) {
        const Sign sign = sign_of_coordinate(triangle, k, q, t);
        if (sign == Sign::negative) {
            return std::nullopt;
        }
        walls |= sign == Sign::zero ? wall_bit(k) : 0U;
    }
    return walls;
}

using IntervalCubic = Coefficients<Interval, 4>;

/// Bernstein coefficients over the range times 1, 3, 3, 1.
IntervalCubic bernstein(const IntervalCubic& c, Range range) {
    // p(u) = C(lo + u (hi - lo)), then (1 + u)^3 p(1 / (1 + u)) backwards, as in ExactPolynomial::bernstein().
    const Interval lo(range.lo);
    const Interval width = Interval(range.hi) - lo;
    const Interval p0 = ((c[3] * lo + c[2]) * lo + c[1]) * lo + c[0];
    const Interval p1 = ((3 * c[3] * lo + 2 * c[2]) * lo + c[1]) * width;
    const Interval p2 = (3 * c[3] * lo + c[2]) * width * width;
    const Interval p3 = c[3] * width * width * width;
    return {p0, 3 * p0 + p1, 3 * p0 + 2 * p1 + p2, p0 + p1 + p2 + p3};
}

/// The number of sign changes if every coefficient has a sign, else -1.
int certain_changes(const IntervalCubic& b) {
    int changes = 0;
    Sign last = Sign::zero;
    for (const Interval& x : b) {
        const Sign sign = sign_of(x);
        if (sign == Sign::undecided || sign == Sign::zero) {
            return -1;
        }
        changes += last != Sign::zero && sign != last ? 1 : 0;
        last = sign;
    }
    return changes;
}

/// Narrow bounds around t at which the cubic certainly has the signs -, + and rises in between, if there are such.
std::optional<Range> rising_bounds(const IntervalCubic& c, double t) {
    const Interval value = value_at(c, Interval(t));
    const Interval slope = (3 * c[3] * t + 2 * c[2]) * t + c[1];
    if (!(slope.inf() > 0) || !std::isfinite(value.inf()) || !std::isfinite(value.sup())) {
        return std::nullopt;
    }
    // Twice as far as the value and its rounding can be from zero.
    const double reach = 2 * std::max(-value.inf(), value.sup()) / slope.inf();
    const Range bounds{t - reach, t + reach};
    if (!std::isfinite(bounds.lo) || !std::isfinite(bounds.hi)) {
        return std::nullopt;
    }
    const Interval in(bounds.lo, bounds.hi);
    const bool rises = ((3 * c[3] * in + 2 * c[2]) * in + c[1]).inf() > 0;
    const bool brackets =
        value_at(c, Interval(bounds.lo)).sup() < 0 && value_at(c, Interval(bounds.hi)).inf() > 0 && bounds.lo < t;
    return rises && brackets ? std::optional(bounds) : std::nullopt;
}

/// What the filter knows of the roots within the range that may be inside the triangle.
struct Roots {
    bool complete = false;     ///< there are no others
    std::optional<Range> only; ///< the one there is
};

/// The root within the range, if intervals show that there is none or one.
Roots filtered_roots(const BaseTriangle& triangle, const Vec3& q, Range range, const Preimages& guesses) {
    const UpwardRounding upward;
    const IntervalCubic c = cubic<Interval>(triangle, q);
    const int changes = certain_changes(bernstein(c, range));
    if (changes == 0) {
        return {true, std::nullopt};
    }
    if (changes != 1) {
        return {};
    }
    for (const Preimage& guess : guesses) {
        if (guess.t > range.lo && guess.t < range.hi) {
            const std::optional<Range> bounds = rising_bounds(c, guess.t);
            const bool inside = bounds && bounds->lo >= range.lo && bounds->hi <= range.hi;
            return {inside, inside ? bounds : std::nullopt};
        }
    }
    return {};
}

/// m of the scan triangle at a corner.
template <class Number>
Number seen_at(const BaseTriangle& triangle, int corner, const ScanTriangle& scan_triangle) {
    return dot(exactly<Number>(triangle.d[corner]), normal_of<Number>(scan_triangle));
}

/// alpha_i m_i + alpha_j m_j times w at the point, where w is not zero: alpha = side / w.
template <class Number>
Coefficients<Number, 3> normal_condition_on_lift(const BaseTriangle& triangle, const WallPoint& point,
                                                 const ScanTriangle& scan_triangle) {
    Coefficients<Number, 3> result{Number(0), Number(0), Number(0)};
    for (const int corner : {(point.wall + 1) % 3, (point.wall + 2) % 3}) {
        const Coefficients<Number, 3> alpha = side<Number>(triangle, corner, point.line);
        const Number m = seen_at<Number>(triangle, corner, scan_triangle);
        for (std::size_t n = 0; n < 3; ++n) {
            result[n] = result[n] + m * alpha[n];
        }
    }
    return result;
}

/// The same in a slice, where alpha is linear between both ends of the line, and alpha_k falls from a to b: alpha (a -
/// b) = a alpha(to) - b alpha(from).
template <class Number>
Coefficients<Number, 5> normal_condition_in_slice(const BaseTriangle& triangle, const WallPoint& point,
                                                  const ScanTriangle& scan_triangle) {
    const VectorOf<Number> c = exactly<Number>(triangle.d[0]);
    const Coefficients<Number, 3> a = side<Number>(triangle, point.wall, *point.line.from, c);
    const Coefficients<Number, 3> b = side<Number>(triangle, point.wall, *point.line.to, c);
    Coefficients<Number, 5> result{Number(0), Number(0), Number(0), Number(0), Number(0)};
    for (const int corner : {(point.wall + 1) % 3, (point.wall + 2) % 3}) {
        const Coefficients<Number, 3> from = side<Number>(triangle, corner, *point.line.from, c);
        const Coefficients<Number, 3> to = side<Number>(triangle, corner, *point.line.to, c);
        const Number m = seen_at<Number>(triangle, corner, scan_triangle);
        for (std::size_t n = 0; n < 9; ++n) {
            result[n / 3 + n % 3] = result[n / 3 + n % 3] + m * (a[n / 3] * to[n % 3] - b[n / 3] * from[n % 3]);
        }
    }
    return result;
}

/// m at the place of the crossing: also where the plane of the triangle holds the line of the wall, and does not tell
/// where that is.
Sign normal_condition_at_place(const BaseTriangle& triangle, const WallPoint& point,
                               const ScanTriangle& scan_triangle) {
    const Sign w =
        sign_at(point.t, [&](const auto& zero) { return rise<std::decay_t<decltype(zero)>>(triangle, point.line); });
    if (w == Sign::zero) {
        return sign_at(point.t, [&](const auto& zero) {
            return normal_condition_in_slice<std::decay_t<decltype(zero)>>(triangle, point, scan_triangle);
        });
    }
    const Sign sum = sign_at(point.t, [&](const auto& zero) {
        return normal_condition_on_lift<std::decay_t<decltype(zero)>>(triangle, point, scan_triangle);
    });
    return w == Sign::positive ? sum : -sum;
}

} // namespace

PointFinder::PointFinder(const BaseTriangle& triangle, Range range)
    : triangle_(&triangle), range_(range), inverse_(triangle) {}

PointFinder::Filtered PointFinder::filtered_find(const Vec3& q) const {
    const BaseTriangle& triangle = *triangle_;
    const auto place_at = [&](const Range& bounds) -> std::optional<PrismoidPoint> {
        const Displacement t = Displacement::of_point(triangle, q, bounds);
        const std::optional<Walls> walls = walls_at(triangle, q, t);
        return walls ? std::optional(PrismoidPoint{t, *walls}) : std::nullopt;
    };
    const Preimages guesses = inverse_.preimages(q);
    // The root that is inside, if one is, needs no others to be known: J > 0 allows no second.
    for (const Preimage& guess : guesses) {
        if (!(guess.alpha.minCoeff() >= 0 && guess.t > range_.lo && guess.t < range_.hi)) {
            continue;
        }
        std::optional<Range> bounds;
        {
            const UpwardRounding upward;
            bounds = rising_bounds(cubic<Interval>(triangle, q), guess.t);
        }
        if (bounds && bounds->lo >= range_.lo && bounds->hi <= range_.hi) {
            if (std::optional<PrismoidPoint> place = place_at(*bounds)) {
                return {true, std::move(place)};
            }
        }
    }
    const Roots roots = filtered_roots(triangle, q, range_, guesses);
    return {roots.complete, roots.complete && roots.only ? place_at(*roots.only) : std::nullopt};
}

std::optional<PrismoidPoint> PointFinder::find(const Vec3& q) const {
    if (filters_enabled()) {
        Filtered filtered = filtered_find(q);
        if (filtered.is_decided) {
            return std::move(filtered.place);
        }
    }
    count_exact();
    const ExactPolynomial c = polynomial(cubic<Exact>(*triangle_, q));
    if (c.is_zero()) {
        return std::nullopt; // q lies in every slice: J would have to be 0
    }
    for (RealRoot& root : real_roots_in(c, Exact(range_.lo), Exact(range_.hi))) {
        if (sign_at(root, c.derivative()) != Sign::positive) {
            continue;
        }
        const Displacement t = Displacement::of_root(std::move(root));
        if (const std::optional<Walls> walls = walls_at(*triangle_, q, t)) {
            return PrismoidPoint{t, *walls};
        }
    }
    return std::nullopt;
}

Sign sign_of_coordinate(const BaseTriangle& triangle, int k, const Vec3& q, const Displacement& t) {
    // At a root of the cubic of q, side_k with d_i of the triangle for c is alpha_k J_i(t). With one of the wall's own
    // directions it vanishes term by term if the wall and q lie in one plane across an axis, as in much that was built.
    return sign_at(t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        return side<Number>(triangle, k, q, exactly<Number>(triangle.d[(k + 1) % 3]));
    });
}

Sign normal_condition_at(const BaseTriangle& triangle, const Vec3& q, const Displacement& t,
                         const ScanTriangle& scan_triangle) {
    const auto sees = [&](const Vec3& d) { return ScanNormal(scan_triangle).seen_along(d) == Sign::positive; };
    if (filters_enabled() && std::all_of(triangle.d.begin(), triangle.d.end(), sees)) {
        count_filtered();
        return Sign::positive;
    }
    return sign_at(t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const VectorOf<Number> n = normal_of<Number>(scan_triangle);
        // Sum of alpha_k J_0 times m_k.
        Coefficients<Number, 3> sum{Number(0), Number(0), Number(0)};
        for (int k = 0; k < 3; ++k) {
            const Number m = dot(exactly<Number>(triangle.d[k]), n);
            const Coefficients<Number, 3> alpha = side<Number>(triangle, k, q, exactly<Number>(triangle.d[0]));
            for (std::size_t i = 0; i < 3; ++i) {
                sum[i] = sum[i] + m * alpha[i];
            }
        }
        return sum;
    });
}

Sign normal_condition_at_wall(const BaseTriangle& triangle, const WallPoint& point, const ScanTriangle& scan_triangle) {
    const int i = (point.wall + 1) % 3;
    const int j = (point.wall + 2) % 3;
    // Exactly, so that filters do not matter where the wall's line lies in the plane.
    const auto sees = [&](int corner) { return seen_along(triangle.d[corner], scan_triangle) == Sign::positive; };
    if (sees(i) && sees(j)) {
        return Sign::positive;
    }
    // On the line of the plane with the wall, m = (l_i m_j - l_j m_i) / ((l_i - l_j) + t (m_i - m_j)). The product has
    // the sign of the quotient.
    const Sign sign = sign_at(point.t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const VectorOf<Number> q0 = exactly<Number>(scan_triangle[0]);
        const VectorOf<Number> n = normal_of<Number>(scan_triangle);
        const Number l_i = dot(exactly<Number>(triangle.v[i]) - q0, n);
        const Number l_j = dot(exactly<Number>(triangle.v[j]) - q0, n);
        const Number m_i = dot(exactly<Number>(triangle.d[i]), n);
        const Number m_j = dot(exactly<Number>(triangle.d[j]), n);
        const Number above = l_i * m_j - l_j * m_i;
        return Coefficients<Number, 2>{above * (l_i - l_j), above * (m_i - m_j)};
    });
    return sign == Sign::zero ? normal_condition_at_place(triangle, point, scan_triangle) : sign;
}

RoundedPlace rounded_place(const BaseTriangle& triangle, const Vec3& q, const Displacement& t) {
    const double at = t.approximate();
    const Vec3 a0 = triangle.corner(0, at);
    const Vec3 e1 = triangle.corner(1, at) - a0;
    const Vec3 e2 = triangle.corner(2, at) - a0;
    const Vec3 n = e1.cross(e2);
    const Vec3 p = q - a0;
    int axis = 0;
    n.cwiseAbs().maxCoeff(&axis);
    const auto area = [x = (axis + 1) % 3, y = (axis + 2) % 3](const Vec3& a, const Vec3& b) {
        return a[x] * b[y] - a[y] * b[x];
    };
    const double alpha1 = area(p, e2) / n[axis];
    const double alpha2 = area(e1, p) / n[axis];
    return {Vec3(1 - alpha1 - alpha2, alpha1, alpha2), at};
}

} // namespace foldless
