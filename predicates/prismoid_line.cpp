#include <foldless/predicates/prismoid_line.h>

#include <foldless/predicates/filtered_passage.h>
#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/real_root.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/number_utils.h>

namespace foldless {
namespace {

template <class Number>
using Quadratic = Coefficients<Number, 3>;

int as_int(Sign sign) {
    return sign == Sign::positive ? 1 : sign == Sign::negative ? -1 : 0;
}

/// Whether the quadratic certainly has opposite signs at the ends, which are finite: there is one root in between.
bool have_opposite_signs(const Quadratic<Interval>& c, Range ends) {
    if (!std::isfinite(ends.lo) || !std::isfinite(ends.hi)) {
        return false;
    }
    const Sign at_lo = sign_of(value_at(c, Interval(ends.lo)));
    const Sign at_hi = sign_of(value_at(c, Interval(ends.hi)));
    return at_lo != Sign::undecided && at_lo != Sign::zero && at_hi == -at_lo;
}

/// Bounds of the roots of a quadratic with two of them, as far as intervals can tell them apart.
std::optional<std::array<Range, 2>> filtered_roots(const Quadratic<Interval>& c) {
    const Interval discriminant = c[1] * c[1] - 4 * c[0] * c[2];
    if (!(discriminant.inf() > 0) || c[2].inf() * c[2].sup() <= 0) {
        return std::nullopt;
    }
    const Interval root = CGAL::sqrt(discriminant);
    const bool falls = c[1].inf() + c[1].sup() < 0;
    const Interval h = Interval(-0.5) * (falls ? c[1] - root : c[1] + root);
    if (h.inf() * h.sup() <= 0) {
        return std::nullopt;
    }
    const Interval a = h / c[2];
    const Interval b = c[0] / h;
    std::array<Range, 2> roots{Range{a.inf(), a.sup()}, Range{b.inf(), b.sup()}};
    for (Range& r : roots) {
        // A little wider, so that the signs at the ends are certain.
        const double margin = 4 * (r.hi - r.lo) + 8 * unit_roundoff * std::abs(r.hi);
        r = {r.lo - margin, r.hi + margin};
        if (!have_opposite_signs(c, r)) {
            return std::nullopt;
        }
    }
    if (roots[0].lo > roots[1].lo) {
        std::swap(roots[0], roots[1]);
    }
    return roots[0].hi < roots[1].lo ? std::optional(roots) : std::nullopt;
}

/// Bounds of the root of a quadratic that is linear, as that of a wall with parallel directions is.
std::optional<Range> filtered_linear_root(const Quadratic<Interval>& c) {
    if (sign_of(c[2]) != Sign::zero || sign_of(c[1]) == Sign::undecided || sign_of(c[1]) == Sign::zero) {
        return std::nullopt;
    }
    const Interval root = -c[0] / c[1];
    const double margin = 4 * (root.sup() - root.inf()) + 8 * unit_roundoff * std::abs(root.sup());
    const Range bounds{root.inf() - margin, root.sup() + margin};
    return have_opposite_signs(c, bounds) ? std::optional(bounds) : std::nullopt;
}

/// The roots of a quadratic with two, or of a linear polynomial, between doubles that lie close around them: nothing if
/// doubles cannot tell them apart. Exact, but guided by doubles: nearly all that intervals left open ends here.
std::optional<std::vector<Range>> guided_roots(const ExactPolynomial& f) {
    std::vector<double> guesses;
    const std::vector<Exact>& c = f.coefficients();
    const double c0 = CGAL::to_double(c[0]);
    const double c1 = CGAL::to_double(c[1]);
    if (f.degree() == 1) {
        guesses = {-c0 / c1};
    } else {
        const double c2 = CGAL::to_double(c[2]);
        const double h = -0.5 * (c1 + std::copysign(std::sqrt(std::max(0.0, c1 * c1 - 4 * c0 * c2)), c1));
        guesses = {h / c2, c0 / h};
    }
    std::sort(guesses.begin(), guesses.end());
    std::vector<Range> roots;
    for (const double guess : guesses) {
        const double margin = 16 * unit_roundoff * std::abs(guess) + std::numeric_limits<double>::min();
        const Range bounds{guess - margin, guess + margin};
        const bool is_free = roots.empty() || roots.back().hi < bounds.lo;
        if (!std::isfinite(bounds.lo) || !std::isfinite(bounds.hi) || !is_free) {
            return std::nullopt;
        }
        const Sign at_lo = f.sign_at(Exact(bounds.lo));
        if (at_lo == Sign::zero || f.sign_at(Exact(bounds.hi)) != -at_lo) {
            return std::nullopt;
        }
        roots.push_back(bounds);
    }
    return roots;
}

/// Every number a root of which could be is within the bounds: |root| <= 1 + max |c_i / c_n|, to a power of two.
Exact root_bound(const ExactPolynomial& f) {
    const Exact& lead = f.coefficients().back();
    Exact bound(1);
    for (const Exact& c : f.coefficients()) {
        const auto exceeds = [&] {
            const Exact scaled = bound * lead;
            return sign_of(c * c - scaled * scaled) == Sign::positive;
        };
        while (exceeds()) {
            bound = bound * Exact(4);
        }
    }
    return bound + bound;
}

/// The line in the prismoid of one triangle.
class Follower {
public:
    Follower(const BaseTriangle& triangle, const ScanLine& line, const PrismoidPoint& from, const PrismoidPoint* end)
        : triangle_(triangle), line_(line), from_(from), end_(end == nullptr ? std::nullopt : std::optional(*end)) {
        set_sides();
    }

    Passage follow() {
        if (filters_enabled()) {
            if (ends_before_any_wall()) {
                count_filtered();
                return {Passage::Kind::ends, -1, end_->t};
            }
            if (std::optional<Passage> passage = filtered_exit()) {
                count_filtered();
                return *std::move(passage);
            }
            if (std::optional<Passage> passage = filtered_passage(triangle_, line_, from_, end_ ? &*end_ : nullptr)) {
                count_filtered();
                return *std::move(passage);
            }
        }
        direction_ = as_int(sign_of_rise());
        return direction_ == 0 ? follow_in_slice() : follow_upwards_or_downwards();
    }

private:
    [[nodiscard]] bool is_on(int k) const { return (from_.walls & wall_bit(k)) != 0; }
    [[nodiscard]] bool ends_on(int k) const { return end_ && (end_->walls & wall_bit(k)) != 0; }

    /// The quadratic of wall k; intervals are at hand.
    template <class Number>
    [[nodiscard]] Quadratic<Number> side_in(int k) const {
        if constexpr (std::is_same_v<Number, Interval>) {
            return sides_[k];
        } else {
            return side<Number>(triangle_, k, line_);
        }
    }

    void set_sides();
    [[nodiscard]] Sign sign_of_rise() const {
        return sign_at(from_.t, [&](const auto& zero) -> Quadratic<std::decay_t<decltype(zero)>> {
            if constexpr (std::is_same_v<std::decay_t<decltype(zero)>, Interval>) {
                return rise_;
            } else {
                return rise<std::decay_t<decltype(zero)>>(triangle_, line_);
            }
        });
    }

    [[nodiscard]] int along(Displacement& a, Displacement& b) const;
    [[nodiscard]] bool ends_before_any_wall();
    [[nodiscard]] bool meets_no_wall(int k, const Interval& start, const Interval& end, bool has_end) const;
    [[nodiscard]] std::optional<Passage> filtered_exit();
    [[nodiscard]] double likely_exit(int k) const;
    [[nodiscard]] std::optional<Range> crossing_near(int k, double t) const;
    [[nodiscard]] Passage follow_upwards_or_downwards();
    [[nodiscard]] bool is_on_another_wall(int wall, const Displacement& t) const;
    [[nodiscard]] std::optional<Displacement> first_exit(int k);
    [[nodiscard]] std::optional<Displacement> exit_from_wall(int k);
    [[nodiscard]] std::optional<Displacement> exit_ahead(int k);

    [[nodiscard]] Passage follow_in_slice() const;
    [[nodiscard]] Sign sign_in_slice(int k, const Vec3& q) const;
    [[nodiscard]] Sign compare_in_slice(int j, int k) const;

    const BaseTriangle& triangle_;
    ScanLine line_;
    PrismoidPoint from_; ///< copies, which keep their exact roots once these are asked for
    std::optional<PrismoidPoint> end_;
    Quadratic<Interval> rise_;
    std::array<Quadratic<Interval>, 3> sides_;
    int direction_ = 0; ///< 1 if the displacement grows along the lift, -1 if it falls
};

/// The quadratics in plain doubles with a bound on their rounding: nearly all lines need no more.
void Follower::set_sides() {
    const Vec3 e = *line_.to - *line_.from;
    std::array<Vec3, 3> x; // v_i - q
    std::array<Vec3, 3> ex;
    std::array<Vec3, 3> ed;
    double x_size = 0;
    double d_size = 0;
    for (int i = 0; i < 3; ++i) {
        x[i] = triangle_.v[i] - *line_.from;
        ex[i] = e.cross(x[i]);
        ed[i] = e.cross(triangle_.d[i]);
        x_size = std::max(x_size, max_norm(x[i]));
        d_size = std::max(d_size, max_norm(triangle_.d[i]));
    }
    // side_k = (e x (x_i + t d_i)).(x_j + t d_j). With u the rounding, a component of e x x is the difference of two
    // products of two rounded differences: 4 u on 2 |e||x|. Its product with a rounded difference adds 2 u, the sum of
    // three 2 u: 8 u on 6 |e||x||x'|. 64 instead of 48 covers the second order and what makes an interval of it.
    const double e_size = max_norm(e);
    const bool counted = std::min({e_size, x_size, d_size}) >= least_length;
    const double unit = counted ? 64 * unit_roundoff * e_size : std::numeric_limits<double>::infinity();
    // Of a sum with terms of both signs, one that overflowed hides the others.
    const auto around = [](double value, double error) {
        const double reach = std::isfinite(value) ? error : std::numeric_limits<double>::infinity();
        return std::isfinite(reach) ? Interval(value - reach, value + reach) : Interval(-reach, reach);
    };
    std::array<double, 3> sum{};
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3;
        const int j = (k + 2) % 3;
        const double c0 = ex[i].dot(x[j]);
        const double c1 = ex[i].dot(triangle_.d[j]) + ed[i].dot(x[j]);
        const double c2 = ed[i].dot(triangle_.d[j]);
        if (lie_across_an_axis(triangle_, k, line_)) {
            sides_[k] = {Interval(0), Interval(0), Interval(0)};
            continue;
        }
        sides_[k] = {around(c0, unit * x_size * x_size), around(c1, 2 * unit * x_size * d_size),
                     // Equal directions make the wall flat, and the quadratic linear.
                     triangle_.d[i] == triangle_.d[j] ? Interval(0) : around(c2, unit * d_size * d_size)};
        sum[0] += c0;
        sum[1] += c1;
        sum[2] += triangle_.d[i] == triangle_.d[j] ? 0 : c2;
    }
    // w = N.e is the sum of the three: three times the error, and the rounding of two sums of three such terms.
    rise_ = {around(sum[0], 4 * unit * x_size * x_size), around(sum[1], 8 * unit * x_size * d_size),
             around(sum[2], 4 * unit * d_size * d_size)};
}

// --- t moves ---------------------------------------------------------------------------------------------------------

/// Whether side_k direction stays positive between the start and the end, beside known roots there: a sufficient test.
/// The end may be any displacement, or that of the line's end.
bool Follower::meets_no_wall(int k, const Interval& start, const Interval& end, bool has_end) const {
    const Quadratic<Interval>& c = sides_[k];
    const Interval direction(direction_);
    const bool ends_there = has_end && ends_on(k);
    if (is_on(k) && ends_there) {
        return (c[2] * direction).sup() < 0; // c2 (t - start) (t - end)
    }
    if (is_on(k)) { // (t - start) (c1 + c2 (t + start)), the first factor has the sign of the direction
        return (c[1] + c[2] * (start + start)).inf() > 0 && (c[1] + c[2] * (start + end)).inf() > 0;
    }
    if (ends_there) { // (t - end) (c1 + c2 (t + end)), the first factor has the opposite sign
        return (c[1] + c[2] * (end + end)).sup() < 0 && (c[1] + c[2] * (start + end)).sup() < 0;
    }
    // The Bernstein coefficients over the hull of both, one of each kind.
    const Interval b0 = (c[2] * start + c[1]) * start + c[0];
    const Interval twice_b1 = 2 * c[0] + c[1] * (start + end) + 2 * c[2] * start * end;
    const Interval b2 = (c[2] * end + c[1]) * end + c[0];
    return (b0 * direction).inf() > 0 && (twice_b1 * direction).inf() > 0 && (b2 * direction).inf() > 0;
}

/// The order of two displacements in the direction of the lift: 1 if a comes after b.
int Follower::along(Displacement& a, Displacement& b) const {
    const Range x = a.bounds();
    const Range y = b.bounds();
    if (!filters_enabled() || (x.lo <= y.hi && y.lo <= x.hi)) {
        a.keep_exact();
        b.keep_exact();
    }
    return direction_ * as_int(compare(a, b));
}

/// Whether the line certainly reaches its end in this prismoid, as intervals in t see it: nearly always if it does.
bool Follower::ends_before_any_wall() {
    if (!end_) {
        return false;
    }
    const Range a = from_.t.bounds();
    const Range b = end_->t.bounds();
    if (a.hi >= b.lo && b.hi >= a.lo) {
        return false;
    }
    const UpwardRounding upward;
    const Interval start(a.lo, a.hi);
    direction_ = a.hi < b.lo ? 1 : -1;
    if (!((value_at(rise_, start) * direction_).inf() > 0)) {
        return false;
    }
    const Interval end(b.lo, b.hi);
    return meets_no_wall(0, start, end, true) && meets_no_wall(1, start, end, true) &&
           meets_no_wall(2, start, end, true);
}

/// About the first displacement ahead at which side_k vanishes; infinitely far ahead if there is none.
double Follower::likely_exit(int k) const {
    const auto middle = [](const Interval& x) { return x.inf() + 0.5 * (x.sup() - x.inf()); };
    const double c0 = middle(sides_[k][0]);
    const double c1 = middle(sides_[k][1]);
    const double c2 = middle(sides_[k][2]);
    const double start = from_.t.approximate();
    const double discriminant = c1 * c1 - 4 * c0 * c2;
    double first = std::numeric_limits<double>::infinity();
    if (is_on(k) || !(discriminant >= 0)) {
        return direction_ * first;
    }
    const double h = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
    for (const double root : {h / c2, c0 / h}) {
        const double ahead = direction_ * (root - start);
        first = ahead > 0 && ahead < first ? ahead : first;
    }
    return start + direction_ * first;
}

/// Close bounds around t at which side_k certainly falls from one sign to the other, along the lift.
std::optional<Range> Follower::crossing_near(int k, double t) const {
    const Quadratic<Interval>& c = sides_[k];
    const Interval value = value_at(c, Interval(t));
    // Inside, side_k direction is positive. Along the lift t direction grows: its slope is that of side_k over t.
    const Interval slope = 2 * c[2] * Interval(t) + c[1];
    if (!(slope.sup() < 0)) {
        return std::nullopt;
    }
    const double reach = 2 * std::max(-value.inf(), value.sup()) / -slope.sup();
    const Range bounds{t - reach, t + reach};
    return have_opposite_signs(c, bounds) ? std::optional(bounds) : std::nullopt;
}

/// Where the line leaves, if intervals show that it meets the wall that it most likely meets first, and none before.
std::optional<Passage> Follower::filtered_exit() {
    const UpwardRounding upward;
    const Range from = from_.t.bounds();
    const Interval start(from.lo, from.hi);
    const Sign rising = sign_of(value_at(rise_, start));
    if (rising != Sign::positive && rising != Sign::negative) {
        return std::nullopt;
    }
    direction_ = as_int(rising);
    const std::array<double, 3> t{likely_exit(0), likely_exit(1), likely_exit(2)};
    int wall = 0;
    for (int k = 1; k < 3; ++k) {
        wall = direction_ * (t[k] - t[wall]) < 0 ? k : wall;
    }
    const std::optional<Range> exit = std::isfinite(t[wall]) ? crossing_near(wall, t[wall]) : std::nullopt;
    if (!exit) {
        return std::nullopt;
    }
    // Along the lift: just before the crossing, and just after it.
    const double before = direction_ > 0 ? exit->lo : exit->hi;
    const double after = direction_ > 0 ? exit->hi : exit->lo;
    if (!(direction_ > 0 ? from.hi < before : before < from.lo)) {
        return std::nullopt;
    }
    if (end_) { // beyond the crossing, or not sure
        const Range end = end_->t.bounds();
        if (!(direction_ > 0 ? end.hi < from.lo || after < end.lo : from.hi < end.lo || end.hi < after)) {
            return std::nullopt;
        }
    }
    for (int k = 0; k < 3; ++k) {
        if (!meets_no_wall(k, start, Interval(k == wall ? before : after), false)) {
            return std::nullopt;
        }
    }
    return Passage{Passage::Kind::leaves, wall, Displacement::at_wall(triangle_, wall, line_, *exit)};
}

Passage Follower::follow_upwards_or_downwards() {
    std::optional<Displacement> next;
    int wall = -1;
    bool is_tie = false;
    for (int k = 0; k < 3; ++k) {
        std::optional<Displacement> exit = first_exit(k);
        if (!exit) {
            continue;
        }
        const int order = next ? along(*exit, *next) : -1;
        if (order < 0) {
            next = std::move(exit);
            wall = k;
        }
        is_tie = order == 0 || (is_tie && order > 0);
    }
    if (end_ && along(end_->t, from_.t) >= 0 && (!next || along(*next, end_->t) >= 0)) {
        return {Passage::Kind::ends, -1, end_->t};
    }
    if (!next) {
        return {};
    }
    is_tie = is_tie || (along(*next, from_.t) != 0 && is_on_another_wall(wall, *next));
    return {is_tie ? Passage::Kind::pillar : Passage::Kind::leaves, wall, *next};
}

/// Whether the line, at a point of the wall, is on another wall too: one that it touches there or runs along.
bool Follower::is_on_another_wall(int wall, const Displacement& t) const {
    for (int k = 0; k < 3; ++k) {
        const auto on_wall = [&](const auto& zero) { return side_in<std::decay_t<decltype(zero)>>(k); };
        if (k != wall && sign_at(t, on_wall) == Sign::zero) {
            return true;
        }
    }
    return false;
}

/// Where the line first goes out through wall k, if it does.
std::optional<Displacement> Follower::first_exit(int k) {
    return is_on(k) ? exit_from_wall(k) : exit_ahead(k);
}

/// The wall on which the line starts: side_k = (t - start) (c1 + c2 (t + start)).
std::optional<Displacement> Follower::exit_from_wall(int k) {
    const Sign slope = sign_at(from_.t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const Quadratic<Number> c = side_in<Number>(k);
        return Coefficients<Number, 2>{c[1], Number(2) * c[2]};
    });
    // Beyond the start side_k has the sign of the slope times the direction, and alpha_k = side_k/w that of the slope.
    const Sign curvature = sign_at(Displacement(), [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        return Coefficients<Number, 1>{side_in<Number>(k)[2]};
    });
    if (slope == Sign::negative || (slope == Sign::zero && as_int(curvature) * direction_ < 0)) {
        return from_.t; // it goes out at once
    }
    if (slope == Sign::zero || as_int(curvature) * direction_ >= 0) {
        return std::nullopt; // a double root, or along the wall; or the other root lies behind
    }
    if (filters_enabled()) {
        const UpwardRounding upward;
        const Range start = from_.t.bounds();
        const Quadratic<Interval>& c = sides_[k];
        const Interval other = -c[1] / c[2] - Interval(start.lo, start.hi);
        const Range bounds{other.inf(), other.sup()};
        const bool is_ahead = direction_ > 0 ? bounds.lo > start.hi : bounds.hi < start.lo;
        if (is_ahead && have_opposite_signs(c, bounds)) {
            return Displacement::at_wall(triangle_, k, line_, bounds);
        }
    }
    return exit_ahead(k);
}

/// The first root of side_k beyond the start, where it changes sign.
std::optional<Displacement> Follower::exit_ahead(int k) {
    const auto is_ahead = [&](Displacement& t) { return along(t, from_.t) > 0; };
    if (filters_enabled()) {
        std::optional<std::array<Range, 2>> roots;
        std::optional<Range> only;
        bool none = false;
        {
            const UpwardRounding upward;
            const Quadratic<Interval>& c = sides_[k];
            none = (c[1] * c[1] - 4 * c[0] * c[2]).sup() < 0;
            only = filtered_linear_root(c);
            roots = none || only ? std::nullopt : filtered_roots(c);
        }
        if (only) {
            Displacement t = Displacement::at_wall(triangle_, k, line_, *only);
            return is_ahead(t) ? std::optional(t) : std::nullopt;
        }
        if (none) {
            count_filtered();
            return std::nullopt;
        }
        if (roots) {
            if (direction_ < 0) {
                std::swap((*roots)[0], (*roots)[1]);
            }
            for (const Range& bounds : *roots) {
                Displacement t = Displacement::at_wall(triangle_, k, line_, bounds);
                if (is_ahead(t)) {
                    return t;
                }
            }
            return std::nullopt;
        }
    }
    count_exact();
    const ExactPolynomial c = polynomial(side<Exact>(triangle_, k, line_));
    if (c.degree() < 1) {
        return std::nullopt; // along the wall, or beside it
    }
    const bool is_touch = c.degree() == 2 && gcd(c, c.derivative()).degree() > 0;
    if (is_touch) {
        return std::nullopt;
    }
    std::vector<Displacement> roots;
    if (const std::optional<std::vector<Range>> guided = guided_roots(c)) {
        for (const Range& bounds : *guided) {
            roots.push_back(Displacement::at_wall(triangle_, k, line_, bounds));
        }
    } else {
        const Exact bound = root_bound(c);
        for (RealRoot& root : real_roots_in(c, -bound, bound)) {
            roots.push_back(Displacement::of_root(std::move(root)));
        }
    }
    if (direction_ < 0) {
        std::reverse(roots.begin(), roots.end());
    }
    const auto first = std::find_if(roots.begin(), roots.end(), is_ahead);
    return first == roots.end() ? std::nullopt : std::optional(*first);
}

// --- t is constant ---------------------------------------------------------------------------------------------------

/// The sign of alpha_k of a point of the line, all in the slice at the start's t.
Sign Follower::sign_in_slice(int k, const Vec3& q) const {
    return sign_at(from_.t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        return side<Number>(triangle_, k, q, exactly<Number>(triangle_.d[0]));
    });
}

/// Which of two walls that the line passes outwards it meets first: negative for wall j. alpha falls from a to b at
/// s = a / (a - b), so the sign is that of a_j (a_k - b_k) - a_k (a_j - b_j) = a_k b_j - a_j b_k.
Sign Follower::compare_in_slice(int j, int k) const {
    return sign_at(from_.t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const VectorOf<Number> c = exactly<Number>(triangle_.d[0]);
        const Quadratic<Number> a_j = side<Number>(triangle_, j, *line_.from, c);
        const Quadratic<Number> b_j = side<Number>(triangle_, j, *line_.to, c);
        const Quadratic<Number> a_k = side<Number>(triangle_, k, *line_.from, c);
        const Quadratic<Number> b_k = side<Number>(triangle_, k, *line_.to, c);
        Coefficients<Number, 5> result{Number(0), Number(0), Number(0), Number(0), Number(0)};
        for (std::size_t m = 0; m < 3; ++m) {
            for (std::size_t n = 0; n < 3; ++n) {
                result[m + n] = result[m + n] + a_k[m] * b_j[n] - a_j[m] * b_k[n];
            }
        }
        return result;
    });
}

Passage Follower::follow_in_slice() const {
    if (end_ && compare(end_->t, from_.t) == Sign::zero) {
        return {Passage::Kind::ends, -1, end_->t}; // the slice is convex
    }
    int wall = -1;
    bool is_tie = false;
    for (int k = 0; k < 3; ++k) {
        if (sign_in_slice(k, *line_.to) != Sign::negative) {
            continue;
        }
        const int order = wall < 0 ? -1 : as_int(compare_in_slice(k, wall));
        if (order < 0) {
            wall = k;
        }
        is_tie = order == 0 || (is_tie && order > 0);
    }
    if (wall < 0) { // the end lies in the slice: on a wall, and its place is on the other side of that
        for (int k = 0; k < 3; ++k) {
            if (sign_in_slice(k, *line_.to) == Sign::zero && !is_on(k)) {
                is_tie = wall >= 0;
                wall = k;
            }
        }
    }
    for (int k = 0; wall >= 0 && !is_on(wall) && k < 3; ++k) { // it may run along another wall to the pillar
        is_tie = is_tie || (k != wall && compare_in_slice(k, wall) == Sign::zero);
    }
    return wall < 0 ? Passage{} : Passage{is_tie ? Passage::Kind::pillar : Passage::Kind::leaves, wall, from_.t};
}

} // namespace

Passage follow_line(const BaseTriangle& triangle, const ScanLine& line, const PrismoidPoint& from,
                    const PrismoidPoint* end) {
    return Follower(triangle, line, from, end).follow();
}

} // namespace foldless
