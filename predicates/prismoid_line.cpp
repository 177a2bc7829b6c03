#include <foldless/predicates/prismoid_line.h>

#include <foldless/predicates/filtered_passage.h>
#include <foldless/predicates/line_sides.h>
#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/quick_passage.h>
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
    Follower(const LineInPrismoid& way, const LineSides& sides)
        : triangle_(way.triangle), line_(way.line), from_(way.from),
          end_(way.end == nullptr ? std::nullopt : std::optional(*way.end)) {
        set_sides(sides);
    }

    Passage follow() {
        if (filters_enabled()) {
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

    /// The quadratic of wall k; intervals are at hand.
    template <class Number>
    [[nodiscard]] Quadratic<Number> side_in(int k) const {
        if constexpr (std::is_same_v<Number, Interval>) {
            return sides_[k];
        } else {
            return side<Number>(triangle_, k, line_);
        }
    }

    void set_sides(const LineSides& sides);
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

/// Intervals around the quadratics.
void Follower::set_sides(const LineSides& sides) {
    // Of a sum with terms of both signs, one that overflowed hides the others.
    const auto around = [](double value, double error) {
        const double reach = std::isfinite(value) ? error : std::numeric_limits<double>::infinity();
        return std::isfinite(reach) ? Interval(value - reach, value + reach) : Interval(-reach, reach);
    };
    const double x = sides.x_size;
    const double d = sides.d_size;
    const auto all_around = [&](const LineSides::Quadratic& c, double unit) {
        return Quadratic<Interval>{around(c[0], unit * x * x), around(c[1], 2 * unit * x * d),
                                   around(c[2], unit * d * d)};
    };
    for (int k = 0; k < 3; ++k) {
        sides_[k] = sides.vanishes[k] ? Quadratic<Interval>{Interval(0), Interval(0), Interval(0)}
                                      : all_around(sides.sides[k], sides.unit);
        if (sides.is_flat[k]) { // the quadratic is linear
            sides_[k][2] = Interval(0);
        }
    }
    rise_ = all_around(sides.rise, 4 * sides.unit);
}

// --- t moves ---------------------------------------------------------------------------------------------------------

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
    const LineInPrismoid way{triangle, line, from, end};
    const LineSides sides(triangle, line);
    if (filters_enabled()) {
        if (std::optional<Passage> passage = quick_passage(way, sides)) {
            count_filtered();
            return *std::move(passage);
        }
    }
    return Follower(way, sides).follow();
}

} // namespace foldless
