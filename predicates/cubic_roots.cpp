#include <foldless/predicates/cubic_roots.h>

#include <algorithm>
#include <limits>

namespace foldless {
namespace {

/// Half an ulp of 1: the relative error of one rounding.
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2.0;

/// Relative errors of a Horner evaluation of degree 3: six roundings (Higham 2002, "Accuracy and stability of numerical
/// algorithms", section 5.1), and two for the terms of second order.
constexpr double horner_epsilon = 8.0 * unit_roundoff;

/// The closed forms leave a relative error near 1e-15, or near 1e-4 in the worst cancellation that double coefficients
/// allow short of a hidden leading one; Newton's method doubles the digits, so four steps suffice for both.
constexpr int polish_steps = 4;

/// The quotient of a cubic by (t - root): a t^2 + b t + c.
struct Quadratic {
    double a;
    double b;
    double c;
};

bool finite(const Cubic& cubic) {
    return std::isfinite(cubic.a) && std::isfinite(cubic.b) && std::isfinite(cubic.c) && std::isfinite(cubic.d);
}

/// Adds a root in ascending order; one that overflowed is none.
void add(RealRoots& roots, double t) {
    if (!std::isfinite(t)) {
        return;
    }
    auto place = static_cast<std::size_t>(roots.count++);
    for (; place > 0 && roots.t[place - 1] > t; --place) {
        roots.t[place] = roots.t[place - 1];
    }
    roots.t[place] = t;
}

/// Newton's method, which stops as soon as a step no longer makes the polynomial smaller: it never leaves a root for a
/// worse one, near a double root either. A value of the size of one rounding error cannot be improved.
double polished(const Cubic& cubic, double t) {
    const Cubic sizes{std::abs(cubic.a), std::abs(cubic.b), std::abs(cubic.c), std::abs(cubic.d)};
    double value = cubic.value(t);
    for (int step = 0; step < polish_steps && std::abs(value) > unit_roundoff * error_at(sizes, t); ++step) {
        const double next = t - value / cubic.slope(t);
        const double next_value = cubic.value(next);
        if (!(std::abs(next_value) < std::abs(value))) {
            break;
        }
        t = next;
        value = next_value;
    }
    return t;
}

/// Whether the slope is positive over the whole range, by its Bernstein coefficients.
bool rises(const Cubic& cubic, const Cubic& error, double lo, double hi) {
    const double reach = std::max(std::abs(lo), std::abs(hi));
    const double slope_error = error.slope(reach);
    const double middle = 3.0 * cubic.a * lo * hi + cubic.b * (lo + hi) + cubic.c;
    return cubic.slope(lo) > slope_error && middle > slope_error && cubic.slope(hi) > slope_error;
}

/// The root that a rising cubic has between lo and hi: Newton's method, and the middle where that would leave them.
double root_between(const Cubic& cubic, double lo, double hi, double guess) {
    const Cubic sizes{std::abs(cubic.a), std::abs(cubic.b), std::abs(cubic.c), std::abs(cubic.d)};
    double t = guess;
    for (int step = 0; step < most_newton_steps; ++step) {
        const double value = cubic.value(t);
        if (std::abs(value) <= unit_roundoff * error_at(sizes, t)) {
            break;
        }
        (value < 0.0 ? lo : hi) = t;
        const double change = value / cubic.slope(t);
        const double next = t - change;
        if (std::abs(change) <= last_newton_step * std::abs(t)) {
            return next;
        }
        t = next > lo && next < hi ? next : 0.5 * (lo + hi);
    }
    return t;
}

/// The root farthest from the inflection point, on its own side of it. With t = x - b / 3a the cubic is
/// x^3 - 3 m x + 2 h, and that root has the sign of -h: no cancellation in either form.
double farthest_root(const Cubic& cubic) {
    const double inflection = -cubic.b / (3.0 * cubic.a);
    const double m = inflection * inflection - cubic.c / (3.0 * cubic.a);
    const double h = cubic.value(inflection) / (2.0 * cubic.a);
    const double size = std::abs(h);
    const double cube = m * m * m;
    const double discriminant = h * h - cube;
    double x = 0.0;
    if (discriminant > 0.0) {
        const double root = std::cbrt(size + std::sqrt(discriminant));
        x = root + m / root;
    } else if (m > 0.0) {
        x = 2.0 * std::sqrt(m) * std::cos(std::acos(std::min(1.0, size / std::sqrt(cube))) / 3.0);
    }
    return inflection - std::copysign(x, h);
}

/// Divides from the end that does not cancel: a root that dominates the cubic comes off the constant term, a small one
/// off the leading term. (Kahan 1986, section "deflation")
Quadratic deflated(const Cubic& cubic, double root) {
    if (std::abs(cubic.a * root * root * root) > std::abs(cubic.d)) {
        const double c = -cubic.d / root;
        return {cubic.a, (c - cubic.c) / root, c};
    }
    const double b = cubic.a * root + cubic.b;
    return {cubic.a, b, b * root + cubic.c};
}

/// Adds the real roots of the quotient, polished on the cubic itself. The vertex of the quotient is where the two meet:
/// if the cubic cannot be told from zero there, that is the one root to report.
void add_pair(RealRoots& roots, const Quadratic& quotient, const Cubic& cubic, const Cubic& error) {
    const double vertex = -quotient.b / (2.0 * quotient.a);
    if (std::abs(cubic.value(vertex)) <= error_at(error, vertex)) {
        return add(roots, vertex);
    }
    const double discriminant = quotient.b * quotient.b - 4.0 * quotient.a * quotient.c;
    if (discriminant > 0.0) {
        const double larger = -0.5 * (quotient.b + std::copysign(std::sqrt(discriminant), quotient.b));
        add(roots, polished(cubic, larger / quotient.a));
        add(roots, polished(cubic, quotient.c / larger));
    }
}

/// Whether zero is a root without any doubt, as for a base corner. It is divided out exactly, so a double root at zero
/// is one at zero, and not two at the square root of rounding.
bool has_root_zero(const Cubic& cubic, const Cubic& error) {
    const bool constant = cubic.a == 0.0 && cubic.b == 0.0 && cubic.c == 0.0;
    return cubic.d == 0.0 && error.d == 0.0 && !constant;
}

/// The roots of t p(t) from those of p(t).
RealRoots with_root_zero(RealRoots roots) {
    if (!roots.everywhere && std::find(roots.begin(), roots.end(), 0.0) == roots.end()) {
        add(roots, 0.0);
    }
    return roots;
}

} // namespace

RealRoots real_roots(const Cubic& cubic, const Cubic& error) {
    RealRoots roots;
    if (!finite(cubic)) {
        return roots;
    }
    if (has_root_zero(cubic, error)) {
        return with_root_zero(real_roots({0.0, cubic.a, cubic.b, cubic.c}, {0.0, error.a, error.b, error.c}));
    }
    if (std::abs(cubic.a) > error.a) {
        const double root = polished(cubic, farthest_root(cubic));
        add(roots, root);
        add_pair(roots, deflated(cubic, root), cubic, error);
    } else if (std::abs(cubic.b) > error.b) {
        add_pair(roots, {cubic.b, cubic.c, cubic.d}, {0.0, cubic.b, cubic.c, cubic.d}, error);
    } else if (std::abs(cubic.c) > error.c) {
        add(roots, -cubic.d / cubic.c);
    } else {
        roots.everywhere = std::abs(cubic.d) <= error.d;
    }
    return roots;
}

std::optional<RealRoots> rising_root(const Cubic& cubic, const Cubic& error, double lo, double hi) {
    if (!rises(cubic, error, lo, hi)) {
        return std::nullopt;
    }
    const double at_lo = cubic.value(lo);
    const double at_hi = cubic.value(hi);
    RealRoots roots;
    if (at_lo > error_at(error, lo) || at_hi < -error_at(error, hi)) {
        return roots;
    }
    if (!(at_lo < -error_at(error, lo) && at_hi > error_at(error, hi))) {
        return std::nullopt;
    }
    add(roots, root_between(cubic, lo, hi, lo - at_lo * (hi - lo) / (at_hi - at_lo)));
    return roots;
}

RealRoots real_roots(const Cubic& cubic) {
    return real_roots(cubic, {horner_epsilon * std::abs(cubic.a), horner_epsilon * std::abs(cubic.b),
                              horner_epsilon * std::abs(cubic.c), horner_epsilon * std::abs(cubic.d)});
}

} // namespace foldless
