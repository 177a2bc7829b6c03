/// \file
/// The quick path of InverseDisplacement::preimages() on the lanes of an instruction set. Each function has the formula
/// of its namesake in inverse_displacement.cpp or cubic_roots.cpp, in the same order of operations.
#pragma once

#include <foldless/predicates/batch_inversion.h>
#include <foldless/predicates/lanes.h>
#include <foldless/predicates/rounding.h>

#include <limits>

namespace foldless::FOLDLESS_LANES {

using InversionTerms = InverseDisplacement::Terms;

/// A cubic for each lane.
struct LaneCubic {
    Real a, b, c, d;
};

/// A range of displacements for each lane.
struct LaneRange {
    Real lo, hi;
};

/// What is known of the roots of each lane.
struct LaneRoots {
    Mask none;   ///< certainly none in the range
    Mask single; ///< certainly one: t
    Real t;
};

FOLDLESS_INLINE Mask is_finite(Real a) {
    return at_most(absolute(a), all(std::numeric_limits<double>::max()));
}

FOLDLESS_INLINE Real dot(const LaneVector& a, const LaneVector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

FOLDLESS_INLINE LaneVector cross(const LaneVector& a, const LaneVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// p + t d
FOLDLESS_INLINE LaneVector along(const Vec3& p, Real t, const Vec3& d) {
    return {all(p[0]) + t * all(d[0]), all(p[1]) + t * all(d[1]), all(p[2]) + t * all(d[2])};
}

FOLDLESS_INLINE Real value(const LaneCubic& cubic, Real t) {
    return ((cubic.a * t + cubic.b) * t + cubic.c) * t + cubic.d;
}

FOLDLESS_INLINE Real slope(const LaneCubic& cubic, Real t) {
    return (all(3.0) * cubic.a * t + all(2.0) * cubic.b) * t + cubic.c;
}

FOLDLESS_INLINE Real error_at(const LaneCubic& error, Real t) {
    return value(error, absolute(t));
}

/// Origin - q, scaled.
FOLDLESS_INLINE LaneVector relative(const InversionTerms& terms, const LaneVector& q) {
    const Real scale = all(terms.inverse_length);
    return {(all(terms.origin[0]) - q.x) * scale, (all(terms.origin[1]) - q.y) * scale,
            (all(terms.origin[2]) - q.z) * scale};
}

FOLDLESS_INLINE LaneCubic cubic_of(const InversionTerms& terms, const LaneVector& p0) {
    return {all(terms.a), dot(p0, terms.t_dd) + all(terms.d0_t_pd), dot(p0, terms.t_pd) + all(terms.d0_t_pp),
            dot(p0, terms.t_pp)};
}

FOLDLESS_INLINE LaneCubic error_of(const InversionTerms& terms, const LaneVector& p0) {
    const Real p = all(InversionTerms::coefficient_epsilon) * (absolute(p0.x) + absolute(p0.y) + absolute(p0.z));
    const double d = terms.direction_error;
    return {all(d * terms.size_dd), p * all(terms.size_dd) + all(d * terms.size_pd),
            p * all(terms.size_pd) + all(d * terms.size_pp), p * all(terms.size_pp)};
}

FOLDLESS_INLINE Mask rises(const LaneCubic& cubic, const LaneCubic& error, const LaneRange& range) {
    const Real slope_error = slope(error, greater_of(absolute(range.lo), absolute(range.hi)));
    const Real middle = all(3.0) * cubic.a * range.lo * range.hi + cubic.b * (range.lo + range.hi) + cubic.c;
    return both(both(less(slope_error, slope(cubic, range.lo)), less(slope_error, middle)),
                less(slope_error, slope(cubic, range.hi)));
}

/// The root in the range of the lanes in `open`; of the others no matter what.
FOLDLESS_INLINE Real root_between(const LaneCubic& cubic, LaneRange range, Real guess, Mask open) {
    const LaneCubic sizes{absolute(cubic.a), absolute(cubic.b), absolute(cubic.c), absolute(cubic.d)};
    Real t = guess;
    for (int step = 0; step < most_newton_steps && bits(open) != 0; ++step) {
        const Real here = value(cubic, t);
        open = but_not(open, at_most(absolute(here), all(unit_roundoff) * error_at(sizes, t)));
        const Mask below = less(here, all(0.0));
        range.lo = select(below, t, range.lo);
        range.hi = select(below, range.hi, t);
        const Real change = here / slope(cubic, t);
        const Real next = t - change;
        const Mask last = at_most(absolute(change), all(last_newton_step) * absolute(t));
        const Mask stays = either(last, both(less(range.lo, next), less(next, range.hi)));
        t = select(open, select(stays, next, all(0.5) * (range.lo + range.hi)), t);
        open = but_not(open, last);
    }
    return t;
}

FOLDLESS_INLINE LaneRoots rising_root(const LaneCubic& cubic, const LaneCubic& error, const LaneRange& range) {
    // Over a range that is not finite it does not rise for sure: that of the errors is not finite either, or NaN.
    const Mask known = rises(cubic, error, range);
    const Real at_lo = value(cubic, range.lo);
    const Real at_hi = value(cubic, range.hi);
    const Real error_lo = error_at(error, range.lo);
    const Real error_hi = error_at(error, range.hi);
    const Mask above = less(error_lo, at_lo);
    const Mask below = less(at_hi, -error_hi);
    const Mask single = both(known, both(less(at_lo, -error_lo), less(error_hi, at_hi)));
    const Real guess = range.lo - at_lo * (range.hi - range.lo) / (at_hi - at_lo);
    return {both(known, either(above, below)), single, root_between(cubic, range, guess, single)};
}

/// The axis nearest to a normal, the first of several; and how long the normal is along it.
struct LaneAxis {
    Mask is_y_or_z, is_z;
    Real size;
};

FOLDLESS_INLINE LaneAxis axis_of(const LaneVector& normal) {
    const Real x = absolute(normal.x);
    const Real y = absolute(normal.y);
    const Real z = absolute(normal.z);
    const Real of_yz = greater_of(y, z);
    return {less(x, of_yz), less(y, z), greater_of(x, of_yz)};
}

FOLDLESS_INLINE Real along(const LaneAxis& axis, const LaneVector& v) {
    return select(axis.is_y_or_z, select(axis.is_z, v.z, v.y), v.x);
}

/// Solutions whose t is known in scaled units.
struct LanePreimages {
    Mask is_plain; ///< the scalar code has these numbers, too
    Real alpha0, alpha1, alpha2, slope;
};

FOLDLESS_INLINE LanePreimages preimages_at(const InversionTerms& terms, const LaneVector& p0, Real t) {
    const LaneVector edge1 = along(terms.p1, t, terms.d1);
    const LaneVector edge2 = along(terms.p2, t, terms.d2);
    const LaneVector to_corner{p0.x + t * all(terms.d0[0]), p0.y + t * all(terms.d0[1]), p0.z + t * all(terms.d0[2])};
    const LaneVector normal = cross(edge1, edge2);
    const Real size1 = all(terms.size_p1) + absolute(t) * all(terms.size_d1);
    const Real size2 = all(terms.size_p2) + absolute(t) * all(terms.size_d2);
    const LaneAxis axis = axis_of(normal);
    const Mask is_large = less(all(InversionTerms::surely_no_degenerate_slice) * size1 * size2, axis.size);

    // The areas beside the point, which is -to_corner: turning both factors round leaves every bit as it is.
    const Real area = along(axis, normal);
    const Real alpha1 = along(axis, cross(edge2, to_corner)) / area;
    const Real alpha2 = along(axis, cross(to_corner, edge1)) / area;
    const Real alpha0 = all(1.0) - alpha1 - alpha2;
    const LaneVector direction{all(terms.d0[0]) + alpha1 * all(terms.d1[0]) + alpha2 * all(terms.d2[0]),
                               all(terms.d0[1]) + alpha1 * all(terms.d1[1]) + alpha2 * all(terms.d2[1]),
                               all(terms.d0[2]) + alpha1 * all(terms.d1[2]) + alpha2 * all(terms.d2[2])};
    const Real slope =
        dot(normal, direction) * all(terms.length_unit) * all(terms.direction_unit) * all(terms.length_unit);

    // A slope of zero may be one that underflowed. A component of N or a coordinate that is not finite leaves none of
    // the products in the slope, or not alpha0, finite.
    const Mask is_sound = both(less(all(0.0), absolute(slope)), both(is_finite(slope), is_finite(alpha0)));
    return {both(is_large, is_sound), alpha0, alpha1, alpha2, slope};
}

/// Answers from lane `first` on.
FOLDLESS_INLINE void solve(const InversionTerms& terms, const PointBatch& points, BatchAnswers& answers, int first) {
    const LaneVector q{load(&points.x[first]), load(&points.y[first]), load(&points.z[first])};
    const LaneRange range{load(&points.lo[first]), load(&points.hi[first])};
    const LaneVector p0 = relative(terms, q);
    const Real per_unit = all(terms.inverse_displacement_unit);
    const LaneRoots roots =
        rising_root(cubic_of(terms, p0), error_of(terms, p0), {range.lo * per_unit, range.hi * per_unit});
    answers.none |= bits(roots.none) << first;
    if (bits(roots.single) == 0) {
        return;
    }
    const Real t = roots.t * all(terms.displacement_unit);
    const Mask in_range = both(at_most(range.lo, t), at_most(t, range.hi));
    const LanePreimages found = preimages_at(terms, p0, roots.t);
    store(&answers.alpha[0][first], found.alpha0);
    store(&answers.alpha[1][first], found.alpha1);
    store(&answers.alpha[2][first], found.alpha2);
    store(&answers.t[first], t);
    store(&answers.slope[first], found.slope);
    // Rounding moves a root out of the range, or it overflows: then there is none.
    answers.none |= bits(but_not(roots.single, in_range)) << first;
    answers.single |= bits(both(both(roots.single, in_range), found.is_plain)) << first;
}

/// Solves the points that are plain.
FOLDLESS_INLINE void solve_all(const InversionTerms& terms, const PointBatch& points, BatchAnswers& answers) {
    answers.none = 0;
    answers.single = 0;
    for (int first = 0; first < points.size; first += lanes) {
        solve(terms, points, answers, first);
    }
}

} // namespace foldless::FOLDLESS_LANES
