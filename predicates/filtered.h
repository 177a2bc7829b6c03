/// \file
/// Signs of polynomials in doubles: intervals first, exact numbers where they cannot tell. For the sources of this
/// layer only.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/sign_counts.h>
#include <foldless/predicates/vector.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

#include <array>

namespace foldless {

/// Rounds upwards as long as it lives; every computation with Interval needs one in scope.
using Interval = CGAL::Interval_nt<false>;
using UpwardRounding = Interval::Protector;

/// An integer times a power of two, of any size: sums, differences and products of doubles, exactly.
using Exact = CGAL::Mpzf;

template <class Number>
using VectorOf = std::array<Number, 3>;

/// The same vector in another number type; nothing is lost.
template <class Number>
VectorOf<Number> exactly(const Vec3& v) {
    return {Number(v.x()), Number(v.y()), Number(v.z())};
}
template <class Number>
VectorOf<Number> operator-(const VectorOf<Number>& a, const VectorOf<Number>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
VectorOf<Number> operator+(const VectorOf<Number>& a, const VectorOf<Number>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class Number>
VectorOf<Number> operator*(const Number& s, const VectorOf<Number>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
template <class Number>
VectorOf<Number> cross(const VectorOf<Number>& a, const VectorOf<Number>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class Number>
Number dot(const VectorOf<Number>& a, const VectorOf<Number>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// n = (q1 - q0) x (q2 - q0).
template <class Number>
VectorOf<Number> normal_of(const ScanTriangle& triangle) {
    const VectorOf<Number> q0 = exactly<Number>(triangle[0]);
    return cross(exactly<Number>(triangle[1]) - q0, exactly<Number>(triangle[2]) - q0);
}

/// The sign of every number in the interval, if they all have the same.
inline Sign sign_of(const Interval& x) {
    if (x.inf() > 0) {
        return Sign::positive;
    }
    if (x.sup() < 0) {
        return Sign::negative;
    }
    return x.inf() == 0 && x.sup() == 0 ? Sign::zero : Sign::undecided;
}

inline Sign sign_of(const Exact& x) {
    switch (CGAL::sign(x)) {
    case CGAL::POSITIVE: return Sign::positive;
    case CGAL::NEGATIVE: return Sign::negative;
    default: return Sign::zero;
    }
}

void count_filtered();
void count_exact();

/// What `decide` answers in intervals, or where that is undecided, in exact numbers. It is called with a zero of the
/// number type and must be right in both; the inputs must be finite.
template <class Decide>
Sign filtered(const Decide& decide) {
    if (filters_enabled()) {
        const UpwardRounding upward;
        const Sign sign = decide(Interval(0));
        if (sign != Sign::undecided) {
            count_filtered();
            return sign;
        }
    }
    count_exact();
    return decide(Exact(0));
}

} // namespace foldless
