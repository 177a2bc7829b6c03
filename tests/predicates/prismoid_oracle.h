/// \file
/// An oracle for places and lines in prismoids: rational arithmetic, polynomials by interpolation of determinants,
/// roots by Sturm's theorem and bisection. Shares no code and no formula with the predicates; slow.
#pragma once

#include <foldless/predicates/vector.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace foldless::oracle {

using Rational = mpq_class;
using Vector = std::array<Rational, 3>;

// --- polynomials
// ------------------------------------------------------------------------------------------------------

/// Coefficients of t^0, t^1, ...; the last is not zero, none for the zero polynomial.
using Polynomial = std::vector<Rational>;

inline Polynomial trimmed(Polynomial p) {
    while (!p.empty() && p.back() == 0) {
        p.pop_back();
    }
    return p;
}

inline Rational value(const Polynomial& p, const Rational& t) {
    Rational result = 0;
    for (std::size_t i = p.size(); i-- > 0;) {
        result *= t;
        result += p[i];
    }
    return result;
}

inline Polynomial combination(const Rational& x, const Polynomial& a, const Rational& y, const Polynomial& b) {
    Polynomial result(std::max(a.size(), b.size()), Rational(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        result[i] += x * a[i];
    }
    for (std::size_t i = 0; i < b.size(); ++i) {
        result[i] += y * b[i];
    }
    return trimmed(result);
}

inline Polynomial product(const Polynomial& a, const Polynomial& b) {
    if (a.empty() || b.empty()) {
        return {};
    }
    Polynomial result(a.size() + b.size() - 1, Rational(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            result[i + j] += a[i] * b[j];
        }
    }
    return result;
}

inline Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) {
        result.push_back(p[i] * static_cast<unsigned long>(i));
    }
    return result;
}

/// The polynomial of at most this degree with the values of f, by Newton's divided differences at 0, 1, -1, 2, ...
template <class Function>
Polynomial interpolated(int degree, const Function& f) {
    std::vector<Rational> nodes;
    std::vector<Rational> differences;
    for (int i = 0; i <= degree; ++i) {
        nodes.emplace_back(i % 2 == 1 ? (i + 1) / 2 : -i / 2);
        differences.push_back(f(nodes.back()));
    }
    for (int order = 1; order <= degree; ++order) {
        for (int i = degree; i >= order; --i) {
            differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - order]);
        }
    }
    Polynomial result;
    for (int i = degree; i >= 0; --i) {
        result = combination(1, product(result, {-nodes[i], 1}), 1, trimmed({differences[i]}));
    }
    return result;
}

inline Polynomial remainder(Polynomial a, const Polynomial& b) {
    while (a.size() >= b.size()) {
        const Rational factor = a.back() / b.back();
        const std::size_t shift = a.size() - b.size();
        for (std::size_t i = 0; i + 1 < b.size(); ++i) {
            a[shift + i] -= factor * b[i];
        }
        a.pop_back();
        a = trimmed(std::move(a));
    }
    return a;
}

inline Polynomial quotient(Polynomial a, const Polynomial& b) {
    Polynomial result(a.size() - b.size() + 1, Rational(0));
    while (a.size() >= b.size()) {
        const std::size_t shift = a.size() - b.size();
        result[shift] = a.back() / b.back();
        for (std::size_t i = 0; i + 1 < b.size(); ++i) {
            a[shift + i] -= result[shift] * b[i];
        }
        a.pop_back();
        a = trimmed(std::move(a));
    }
    return result;
}

/// Divided by the size of its leading coefficient, which keeps the numbers of a chain short.
inline Polynomial normalised(Polynomial p) {
    if (!p.empty()) {
        const Rational lead = abs(p.back());
        for (Rational& x : p) {
            x /= lead;
        }
    }
    return p;
}

inline Polynomial common_divisor(Polynomial a, Polynomial b) {
    while (!b.empty()) {
        Polynomial rest = normalised(remainder(a, b));
        a = std::exchange(b, std::move(rest));
    }
    return a;
}

/// Sturm's chain of p.
inline std::vector<Polynomial> sturm_chain(const Polynomial& p) {
    std::vector<Polynomial> chain{p, derivative(p)};
    while (!chain.back().empty()) {
        Polynomial rest = normalised(remainder(chain[chain.size() - 2], chain.back()));
        for (Rational& x : rest) {
            x = -x;
        }
        chain.push_back(std::move(rest));
    }
    chain.pop_back();
    return chain;
}

inline int variations(const std::vector<Polynomial>& chain, const Rational& t) {
    int count = 0;
    int last = 0;
    for (const Polynomial& p : chain) {
        const int sign = sgn(value(p, t));
        count += sign != 0 && last != 0 && sign != last ? 1 : 0;
        last = sign != 0 ? sign : last;
    }
    return count;
}

// --- roots
// ------------------------------------------------------------------------------------------------------------

/// A root of the polynomial f, whose roots are simple: lo itself if lo = hi, else the only one in (lo, hi), with
/// opposite signs at the ends.
struct Root {
    Polynomial f;
    Rational lo;
    Rational hi;

    [[nodiscard]] bool is_rational() const { return lo == hi; }
    void refine() {
        if (is_rational()) {
            return;
        }
        const Rational middle = (lo + hi) / 2;
        const int sign = sgn(value(f, middle));
        if (sign == 0) {
            lo = middle;
            hi = middle;
        } else if (sign == sgn(value(f, lo))) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    void refine(int steps) {
        for (int step = 0; step < steps && !is_rational(); ++step) {
            refine();
        }
    }
};

inline Root root_at(const Rational& t) {
    return {{-t, 1}, t, t};
}

/// Roots in (lo, hi] by bisection.
inline void isolate(const Polynomial& f, const std::vector<Polynomial>& chain, const Rational& lo, const Rational& hi,
                    int at_lo, int at_hi, std::vector<Root>& roots) {
    const int count = at_lo - at_hi;
    if (count == 0) {
        return;
    }
    if (count == 1) {
        if (value(f, hi) == 0) {
            roots.push_back({f, hi, hi});
            return;
        }
        if (value(f, lo) != 0) {
            roots.push_back({f, lo, hi});
            return;
        }
    }
    const Rational middle = (lo + hi) / 2;
    const int at_middle = variations(chain, middle);
    isolate(f, chain, lo, middle, at_lo, at_middle, roots);
    isolate(f, chain, middle, hi, at_middle, at_hi, roots);
}

/// The distinct real roots of p in [lo, hi], ascending. \pre p is not zero
inline std::vector<Root> roots_in(const Polynomial& p, const Rational& lo, const Rational& hi) {
    std::vector<Root> roots;
    if (p.size() < 2) {
        return roots;
    }
    const Polynomial repeated = common_divisor(p, derivative(p));
    const Polynomial f = repeated.size() > 1 ? quotient(p, repeated) : p;
    if (value(f, lo) == 0) {
        roots.push_back({f, lo, lo});
    }
    if (lo < hi) {
        const std::vector<Polynomial> chain = sturm_chain(f);
        isolate(f, chain, lo, hi, variations(chain, lo), variations(chain, hi), roots);
    }
    return roots;
}

/// All real roots, within Cauchy's bound.
inline std::vector<Root> roots_of(const Polynomial& p) {
    Rational bound = 1;
    for (const Rational& x : p) {
        bound = std::max<Rational>(bound, 1 + abs(x / p.back()));
    }
    return roots_in(p, -bound, bound);
}

/// The sign of g at the root.
inline int sign_at(Root root, const Polynomial& g) {
    if (g.size() < 2) {
        return g.empty() ? 0 : sgn(g[0]);
    }
    std::vector<Polynomial> chain;
    for (int steps = 8; !root.is_rational(); steps *= 2) {
        // By the mean value theorem first: |g| at the middle exceeds what g can change over the interval.
        const Rational middle = (root.lo + root.hi) / 2;
        const Rational half = (root.hi - root.lo) / 2;
        const Rational far = std::max<Rational>(abs(root.lo), abs(root.hi));
        Rational slope = 0;
        Rational power = 1;
        for (std::size_t i = 1; i < g.size(); ++i) {
            slope += static_cast<unsigned long>(i) * abs(g[i]) * power;
            power *= far;
        }
        const Rational at_middle = value(g, middle);
        if (abs(at_middle) > slope * half) {
            return sgn(at_middle);
        }
        if (steps == 32) {
            const Polynomial common = common_divisor(root.f, g);
            if (common.size() > 1) {
                const std::vector<Polynomial> common_chain = sturm_chain(common);
                if (variations(common_chain, root.lo) != variations(common_chain, root.hi)) {
                    return 0;
                }
            }
        }
        root.refine(steps);
    }
    return sgn(value(g, root.lo));
}

/// The sign of a - b.
inline int compare(Root a, Root b) {
    for (int steps = 8;; steps *= 2) {
        if (a.is_rational() && b.is_rational()) {
            return sgn(Rational(a.lo - b.lo));
        }
        if (a.hi <= b.lo) {
            return -1; // at least one of the two intervals is open
        }
        if (b.hi <= a.lo) {
            return 1;
        }
        if (a.is_rational() || b.is_rational()) {
            const Root& exact = a.is_rational() ? a : b;
            const Root& other = a.is_rational() ? b : a;
            if (value(other.f, exact.lo) == 0) {
                return 0;
            }
        } else if (steps == 32) {
            const Polynomial common = common_divisor(a.f, b.f);
            if (common.size() > 1 && !roots_in(common, std::max(a.lo, b.lo), std::min(a.hi, b.hi)).empty()) {
                return 0;
            }
        }
        a.refine(steps);
        b.refine(steps);
    }
}

/// A number between two different roots, a < b.
inline Rational between(Root a, Root b) {
    while (!(a.hi < b.lo)) {
        a.refine();
        b.refine();
        if (a.hi == b.lo && !(a.is_rational() && b.is_rational()) && !a.is_rational() && !b.is_rational()) {
            return a.hi; // both intervals are open
        }
    }
    return (a.hi + b.lo) / 2;
}

// --- prismoids
// --------------------------------------------------------------------------------------------------------

inline Vector vector(const Vec3& v) {
    return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational determinant(const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The corners of the slice at t.
inline std::array<Vector, 3> slice(const BaseTriangle& triangle, const Rational& t) {
    std::array<Vector, 3> result;
    for (int i = 0; i < 3; ++i) {
        for (int c = 0; c < 3; ++c) {
            result[i][c] = Rational(triangle.v[i][c]) + t * Rational(triangle.d[i][c]);
        }
    }
    return result;
}

/// C_q as six times the volume of the tetrahedron of q and the slice.
inline Polynomial cubic(const BaseTriangle& triangle, const Vec3& q) {
    const Vector p = vector(q);
    return interpolated(3, [&](const Rational& t) {
        const auto a = slice(triangle, t);
        return determinant(a[0] - p, a[1] - p, a[2] - p);
    });
}

/// alpha_k times |N|^2 > 0 of the foot of q in the slice: areas along the normal of the slice.
inline Polynomial area(const BaseTriangle& triangle, int k, const Vec3& q) {
    const Vector p = vector(q);
    return interpolated(4, [&](const Rational& t) {
        const auto a = slice(triangle, t);
        const Vector n = cross(a[1] - a[0], a[2] - a[0]);
        return dot(n, cross(a[(k + 1) % 3] - p, a[(k + 2) % 3] - p));
    });
}

/// Whether J > 0 on the prismoid: no J_i has a root on the range, and all are positive at one end.
inline bool jacobian_is_positive(const BaseTriangle& triangle, Range range) {
    for (int i = 0; i < 3; ++i) {
        const Polynomial j = interpolated(2, [&](const Rational& t) {
            const auto a = slice(triangle, t);
            return determinant(a[1] - a[0], a[2] - a[0], vector(triangle.d[i]));
        });
        if (value(j, range.lo) <= 0 || !roots_in(j, range.lo, range.hi).empty()) {
            return false;
        }
    }
    return true;
}

struct Place {
    Root t;
    unsigned walls = 0;
};

/// All places of q in the prismoid, its border included. \pre the cubic is not zero
inline std::vector<Place> places(const BaseTriangle& triangle, Range range, const Vec3& q) {
    std::vector<Place> result;
    for (const Root& root : roots_in(cubic(triangle, q), range.lo, range.hi)) {
        Place place{root};
        bool inside = true;
        for (int k = 0; k < 3 && inside; ++k) {
            const int sign = sign_at(root, area(triangle, k, q));
            inside = sign >= 0;
            place.walls |= sign == 0 ? 1U << k : 0U;
        }
        if (inside) {
            result.push_back(place);
        }
    }
    return result;
}

/// m_k = d_k.n of a scan triangle.
inline Rational seen(const Vec3& d, const ScanTriangle& q) {
    const Vector q0 = vector(q[0]);
    return determinant(vector(d), vector(q[1]) - q0, vector(q[2]) - q0);
}

/// The sign of m at a place of q.
inline int normal_condition(const BaseTriangle& triangle, const Vec3& q, const Root& t, const ScanTriangle& scan) {
    Polynomial m;
    for (int k = 0; k < 3; ++k) {
        m = combination(1, m, seen(triangle.d[k], scan), area(triangle, k, q));
    }
    return sign_at(t, m);
}

/// The line from p to q with the coordinates of its lift as functions of t, by Cramer's rule on
/// a_0 + alpha_1 (a_1 - a_0) + alpha_2 (a_2 - a_0) = p + s (q - p): alpha_k = alpha[k]/denominator, s likewise.
struct Lift {
    std::array<Polynomial, 3> alpha;
    Polynomial s;
    Polynomial denominator;

    Lift(const BaseTriangle& triangle, const Vec3& p, const Vec3& q) {
        const Vector from = vector(p);
        const Vector back = from - vector(q);
        const auto by = [&](int degree, const auto& columns) {
            return interpolated(degree, [&](const Rational& t) {
                const auto a = slice(triangle, t);
                const std::array<Vector, 3> c = columns(a[1] - a[0], a[2] - a[0], from - a[0]);
                return determinant(c[0], c[1], c[2]);
            });
        };
        using Columns = std::array<Vector, 3>;
        denominator = by(2, [&](const Vector& x, const Vector& y, const Vector&) { return Columns{x, y, back}; });
        alpha[1] = by(2, [&](const Vector&, const Vector& y, const Vector& r) { return Columns{r, y, back}; });
        alpha[2] = by(2, [&](const Vector& x, const Vector&, const Vector& r) { return Columns{x, r, back}; });
        s = by(3, [&](const Vector& x, const Vector& y, const Vector& r) { return Columns{x, y, r}; });
        alpha[0] = combination(1, combination(1, denominator, -1, alpha[1]), -1, alpha[2]);
    }
};

/// Where the lift of a line leaves a prismoid.
struct Exit {
    Root t;
    unsigned out = 0;  ///< walls through which it goes
    unsigned zero = 0; ///< walls on which the point lies
    int past_end = 0;  ///< the sign of s - 1
    bool at_start = false;
};

/// Follows the lift from the start, a place of a point of the line, as far as the window reaches (a little more than
/// the range); nothing if it does not leave before that. \pre J > 0 on the range, which holds the start
inline std::optional<Exit> exit_of(const BaseTriangle& triangle, Range range, const Vec3& p, const Vec3& q,
                                   const Place& place) {
    const Root& start = place.t;
    const Lift lift(triangle, p, q);
    const int rise = -sign_at(start, lift.denominator);
    if (rise == 0) {
        // In one slice: the coordinates of p and q there, linear in between.
        std::array<Polynomial, 3> a;
        std::array<Polynomial, 3> b;
        for (int k = 0; k < 3; ++k) {
            a[k] = area(triangle, k, p);
            b[k] = area(triangle, k, q);
        }
        // Of a_j - (a_j - b_j) s where alpha_k vanishes, s = a_k / (a_k - b_k).
        const auto at_exit = [&](int j, int k) {
            return sign_at(start, combination(1, product(a[j], combination(-1, b[k], 0, {})), 1, product(a[k], b[j])));
        };
        for (int k = 0; k < 3; ++k) {
            if (sign_at(start, b[k]) >= 0) {
                continue;
            }
            Exit exit{start, 1U << k, 1U << k, -1, false};
            bool first = true;
            for (int j = 0; j < 3 && first; ++j) {
                const int sign = j == k ? 1 : at_exit(j, k);
                first = sign >= 0;
                exit.zero |= sign == 0 ? 1U << j : 0U;
                exit.out |= sign == 0 && sign_at(start, b[j]) < 0 ? 1U << j : 0U;
            }
            if (first) {
                exit.at_start = (exit.out & place.walls) != 0;
                return exit;
            }
        }
        return std::nullopt;
    }
    const Rational lo(range.lo);
    const Rational hi(range.hi);
    const Rational margin = lo < hi ? Rational(hi - lo) : Rational(1);
    const Rational edge = rise > 0 ? Rational(hi + margin) : Rational(lo - margin);
    std::vector<Root> stops;
    const auto add = [&](const Polynomial& f) {
        if (f.empty()) {
            return;
        }
        for (const Root& root : rise > 0 ? roots_in(f, lo, edge) : roots_in(f, edge, hi)) {
            const auto same = [&](const Root& other) { return compare(root, other) == 0; };
            if (rise * compare(root, start) > 0 && std::none_of(stops.begin(), stops.end(), same)) {
                stops.push_back(root);
            }
        }
    };
    for (const Polynomial& alpha : lift.alpha) {
        add(alpha);
    }
    add(lift.denominator);
    const Rational last = rise > 0 ? hi : lo; // up to there J > 0
    add({-last, 1});
    add({-edge, 1});
    std::sort(stops.begin(), stops.end(), [&](const Root& a, const Root& b) { return rise * compare(a, b) < 0; });
    Root at = start;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const Rational t = rise > 0 ? between(at, stops[i]) : between(stops[i], at);
        const Rational denominator = value(lift.denominator, t);
        if (i == 0 && lo <= t && t <= hi) { // s grows along the lift
            const Rational s = value(lift.s, t) / denominator;
            if (-rise * sign_at(start, combination(s, lift.denominator, -1, lift.s)) <= 0) {
                throw std::logic_error("the lift runs backwards");
            }
        }
        Exit exit{at};
        for (int k = 0; k < 3; ++k) {
            exit.out |= value(lift.alpha[k], t) / denominator < 0 ? 1U << k : 0U;
            exit.zero |= sign_at(at, lift.alpha[k]) == 0 ? 1U << k : 0U;
        }
        if (exit.out != 0) {
            exit.past_end = -rise * sign_at(at, combination(1, lift.s, -1, lift.denominator));
            exit.at_start = i == 0;
            return exit;
        }
        at = stops[i];
        if (sign_at(at, lift.denominator) == 0) {
            if (compare(at, root_at(lo)) >= 0 && compare(at, root_at(hi)) <= 0) {
                throw std::logic_error("w vanishes along a lift with J > 0");
            }
            return std::nullopt;
        }
    }
    return std::nullopt;
}

/// The sign of m where the line meets the wall opposite corner k at t.
inline int normal_condition_at_wall(const BaseTriangle& triangle, int k, const Vec3& p, const Vec3& q, const Root& t,
                                    const ScanTriangle& scan) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const Lift lift(triangle, p, q);
    const int denominator = sign_at(t, lift.denominator);
    if (denominator != 0) {
        return denominator * sign_at(t, combination(seen(triangle.d[i], scan), lift.alpha[i], seen(triangle.d[j], scan),
                                                    lift.alpha[j]));
    }
    // In the slice: alpha_i (a_k - b_k) = a_k b_i - a_i b_k where alpha_k vanishes, and a_k >= 0 > b_k.
    const Polynomial a_k = area(triangle, k, p);
    const Polynomial b_k = area(triangle, k, q);
    Polynomial m;
    for (const int corner : {i, j}) {
        const Polynomial alpha =
            combination(1, product(a_k, area(triangle, corner, q)), -1, product(b_k, area(triangle, corner, p)));
        m = combination(1, m, seen(triangle.d[corner], scan), alpha);
    }
    return sign_at(t, m);
}

} // namespace foldless::oracle
