/// \file
/// An oracle for the roots of cubics: rational arithmetic and bisection, no formula of the library.
#pragma once

#include <foldless/predicates/vector.h>

#include <gmpxx.h>

#include <array>
#include <vector>

namespace foldless::exact {

/// Coefficients of t^0, t^1, ...; no leading zero, empty for the zero polynomial.
using Polynomial = std::vector<mpq_class>;

inline Polynomial trimmed(Polynomial p) {
    while (!p.empty() && p.back() == 0) {
        p.pop_back();
    }
    return p;
}

inline mpq_class value(const Polynomial& p, const mpq_class& t) {
    mpq_class sum = 0;
    for (auto coefficient = p.rbegin(); coefficient != p.rend(); ++coefficient) {
        sum = sum * t + *coefficient;
    }
    return sum;
}

inline Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) {
        result.push_back(p[i] * static_cast<unsigned long>(i));
    }
    return result;
}

/// A bound on the size of all real roots. (Cauchy)
inline mpq_class root_bound(const Polynomial& p) {
    mpq_class bound = 0;
    for (const mpq_class& coefficient : p) {
        bound = std::max<mpq_class>(bound, abs(coefficient / p.back()));
    }
    return bound + 1;
}

/// Narrows lo < root < hi, where p changes sign exactly once, to 2^-steps of its width.
inline mpq_class bisected(const Polynomial& p, mpq_class lo, mpq_class hi, int steps) {
    const int sign_lo = sgn(value(p, lo));
    for (int step = 0; step < steps; ++step) {
        const mpq_class middle = (lo + hi) / 2;
        const int sign = sgn(value(p, middle));
        if (sign == 0) {
            return middle;
        }
        (sign == sign_lo ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

/// The real roots at which p changes sign, ascending, each to 2^-steps of the root bound: between two neighbouring
/// roots of the derivative there is at most one. Roots of even order are not found.
inline std::vector<mpq_class> sign_changes(const Polynomial& p, int steps) {
    if (p.size() < 2) {
        return {};
    }
    const mpq_class bound = root_bound(p);
    std::vector<mpq_class> stops{-bound};
    for (const mpq_class& stop : sign_changes(derivative(p), steps)) {
        stops.push_back(stop);
    }
    stops.push_back(bound);
    std::vector<mpq_class> roots;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        if (sgn(value(p, stops[i])) * sgn(value(p, stops[i + 1])) < 0) {
            roots.push_back(bisected(p, stops[i], stops[i + 1], steps));
        }
    }
    return roots;
}

using Vector = std::array<mpq_class, 3>;

inline Vector vector(const Vec3& v) {
    return {mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])};
}

inline Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline mpq_class determinant(const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// C_q by the eight determinants of Maggiordomo et al. 2023, eq. 16, without common products.
inline Polynomial cubic(const BaseTriangle& triangle, const Vec3& q) {
    const Vector v0 = vector(triangle.v[0]);
    const Vector d0 = vector(triangle.d[0]);
    const std::array<Vector, 3> p{difference(v0, vector(q)), difference(vector(triangle.v[1]), v0),
                                  difference(vector(triangle.v[2]), v0)};
    const std::array<Vector, 3> d{d0, difference(vector(triangle.d[1]), d0), difference(vector(triangle.d[2]), d0)};
    return trimmed({determinant(p[0], p[1], p[2]),
                    determinant(d[0], p[1], p[2]) + determinant(p[0], d[1], p[2]) + determinant(p[0], p[1], d[2]),
                    determinant(p[0], d[1], d[2]) + determinant(d[0], p[1], d[2]) + determinant(d[0], d[1], p[2]),
                    determinant(d[0], d[1], d[2])});
}

} // namespace foldless::exact
