/// \file
/// The polynomials in t whose roots and signs decide where points and lines lie in a prismoid, in any number type. For
/// the sources of this layer only.
#pragma once

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/filtered.h>
#include <foldless/predicates/real_root.h>
#include <foldless/predicates/vector.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace foldless {

/// Coefficients in ascending order.
template <class Number, std::size_t size>
using Coefficients = std::array<Number, size>;

template <class Number, std::size_t size>
Number value_at(const Coefficients<Number, size>& c, const Number& t) {
    Number result = c[size - 1];
    for (std::size_t i = size - 1; i-- > 0;) {
        result = result * t + c[i];
    }
    return result;
}

template <std::size_t size>
ExactPolynomial polynomial(const Coefficients<Exact, size>& c) {
    return ExactPolynomial(std::vector<Exact>(c.begin(), c.end()));
}

/// The linear vector function v + t d.
template <class Number>
struct Moving {
    VectorOf<Number> v;
    VectorOf<Number> d;
};

template <class Number>
Moving<Number> corner(const BaseTriangle& triangle, int i) {
    return {exactly<Number>(triangle.v[i]), exactly<Number>(triangle.d[i])};
}
template <class Number>
Moving<Number> operator-(const Moving<Number>& a, const Moving<Number>& b) {
    return {a.v - b.v, a.d - b.d};
}
template <class Number>
Moving<Number> operator-(const Moving<Number>& a, const VectorOf<Number>& q) {
    return {a.v - q, a.d};
}

/// c . (a x b).
template <class Number>
Coefficients<Number, 3> triple(const VectorOf<Number>& c, const Moving<Number>& a, const Moving<Number>& b) {
    return {dot(c, cross(a.v, b.v)), dot(c, cross(a.v, b.d) + cross(a.d, b.v)), dot(c, cross(a.d, b.d))};
}

/// C_q(t) = N(t).(a_0(t) - q). (Maggiordomo et al. 2023, eq. 14)
template <class Number>
Coefficients<Number, 4> cubic(const BaseTriangle& triangle, const Vec3& q) {
    const Moving<Number> a0 = corner<Number>(triangle, 0);
    const Moving<Number> e1 = corner<Number>(triangle, 1) - a0;
    const Moving<Number> e2 = corner<Number>(triangle, 2) - a0;
    const Coefficients<Number, 3> low = triple(a0.v - exactly<Number>(q), e1, e2);
    const Coefficients<Number, 3> high = triple(a0.d, e1, e2);
    return {low[0], low[1] + high[0], low[2] + high[1], high[2]};
}

/// w(t) = N(t).e for the line's vector e.
template <class Number>
Coefficients<Number, 3> rise(const BaseTriangle& triangle, const ScanLine& line) {
    const Moving<Number> a0 = corner<Number>(triangle, 0);
    return triple(exactly<Number>(*line.to) - exactly<Number>(*line.from), corner<Number>(triangle, 1) - a0,
                  corner<Number>(triangle, 2) - a0);
}

/// side_k(t) = c.((a_i(t) - q) x (a_j(t) - q)) for the wall from i = k + 1 to j = k + 2: with c the line's vector and q
/// on it, it vanishes where the line meets the wall's line in the slice; at a root of the cubic of q it is alpha_k(t)
/// N(t).c.
template <class Number>
Coefficients<Number, 3> side(const BaseTriangle& triangle, int k, const Vec3& q, const VectorOf<Number>& c) {
    const VectorOf<Number> point = exactly<Number>(q);
    return triple(c, corner<Number>(triangle, (k + 1) % 3) - point, corner<Number>(triangle, (k + 2) % 3) - point);
}

/// The same for a line.
template <class Number>
Coefficients<Number, 3> side(const BaseTriangle& triangle, int k, const ScanLine& line) {
    return side(triangle, k, *line.from, exactly<Number>(*line.to) - exactly<Number>(*line.from));
}

/// Whether the wall and the line lie in one plane across an axis, as they often do in what was built and not scanned:
/// then the line runs within the wall, and side_k vanishes term by term.
inline bool lie_across_an_axis(const BaseTriangle& triangle, int k, const ScanLine& line) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const Vec3& p = *line.from;
    for (int axis = 0; axis < 3; ++axis) {
        if (triangle.d[i][axis] == 0 && triangle.d[j][axis] == 0 && triangle.v[i][axis] == p[axis] &&
            triangle.v[j][axis] == p[axis] && (*line.to)[axis] == p[axis]) {
            return true;
        }
    }
    return false;
}

/// The sign at t of the polynomial whose coefficients `generate(zero)` gives in the number type of its argument.
template <class Generate>
Sign sign_at(const Displacement& t, const Generate& generate) {
    if (filters_enabled()) {
        const UpwardRounding upward;
        const Interval in(t.bounds().lo, t.bounds().hi);
        const Sign sign = sign_of(value_at(generate(Interval(0)), in));
        if (sign != Sign::undecided) {
            count_filtered();
            return sign;
        }
    }
    count_exact();
    const auto exact = generate(Exact(0));
    return t.is_double() ? sign_of(value_at(exact, Exact(t.bounds().lo))) : sign_at(t.exact(), polynomial(exact));
}

} // namespace foldless
