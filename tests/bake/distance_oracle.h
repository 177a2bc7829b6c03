/// \file
/// Distances by formulas of their own, one triangle after the other, in any type of numbers.
#pragma once

#include <foldless/io/scan.h>

#include <algorithm>
#include <array>

namespace foldless::test {

template <class Number>
using Point = std::array<Number, 3>;

template <class Number>
Point<Number> point(const Vec3& p) {
    return {Number(p.x()), Number(p.y()), Number(p.z())};
}

template <class Number>
Point<Number> minus(const Point<Number>& a, const Point<Number>& b) {
    return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
Number dot(const Point<Number>& a, const Point<Number>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Of q to the segment from a to b, by the parameter of the foot of q.
template <class Number>
Number squared_distance_to_segment(const Point<Number>& q, const Point<Number>& a, const Point<Number>& b) {
    const Point<Number> ab = minus(b, a);
    const Point<Number> aq = minus(q, a);
    const Number along = dot(aq, ab);
    if (!(along > 0)) {
        return dot(aq, aq);
    }
    if (!(along < dot(ab, ab))) {
        const Point<Number> bq = minus(q, b);
        return dot(bq, bq);
    }
    return dot(aq, aq) - along * along / dot(ab, ab);
}

/// Of q to a triangle: to its plane where the foot of q lies inside, by Cramer's rule, else to its edges.
template <class Number>
Number squared_distance(const Vec3& query, const ScanTriangle& triangle) {
    const Point<Number> q = point<Number>(query);
    const Point<Number> a = point<Number>(triangle[0]);
    const Point<Number> b = point<Number>(triangle[1]);
    const Point<Number> c = point<Number>(triangle[2]);
    const Point<Number> ab = minus(b, a);
    const Point<Number> ac = minus(c, a);
    const Point<Number> aq = minus(q, a);
    const Number bb = dot(ab, ab);
    const Number bc = dot(ab, ac);
    const Number cc = dot(ac, ac);
    const Number determinant = bb * cc - bc * bc;
    const Number at_b = cc * dot(ab, aq) - bc * dot(ac, aq);
    const Number at_c = bb * dot(ac, aq) - bc * dot(ab, aq);
    if (determinant > 0 && at_b > 0 && at_c > 0 && at_b + at_c < determinant) {
        const Point<Number> normal{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                                   ab[0] * ac[1] - ab[1] * ac[0]};
        const Number height = dot(normal, aq);
        return height * height / determinant;
    }
    return std::min({squared_distance_to_segment(q, a, b), squared_distance_to_segment(q, b, c),
                     squared_distance_to_segment(q, c, a)});
}

} // namespace foldless::test
