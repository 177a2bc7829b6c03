#include <foldless/predicates/filtered_passage.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foldless {
namespace {

/// Covers the few roundings of an expression of positive terms.
constexpr double outwards = 1 + 16 * unit_roundoff;

/// The line p + s e, s in [0, 1], from a point of the prismoid on.
///
/// With a direction c of the triangle, g_k(s, t) = c.((a_i(t) - p - s e) x (a_j(t) - p - s e)) is linear in s, and at a
/// lift alpha_k times the positive number N(t).c. So two values of it, on all the slices that the lift may meet on its
/// way, tell where alpha_k can vanish.
class Sweep {
public:
    Sweep(const BaseTriangle& triangle, const ScanLine& line, const PrismoidPoint& from)
        : triangle_(triangle), line_(line), from_(from) {
        measure();
    }

    [[nodiscard]] std::optional<Passage> passage(const PrismoidPoint* end);

private:
    void measure();
    [[nodiscard]] bool bound(double way);
    [[nodiscard]] bool bound_rate(double reach);
    [[nodiscard]] bool is_on(int k) const { return (from_.walls & wall_bit(k)) != 0; }
    [[nodiscard]] bool is_along(int k) const { return (along_ & wall_bit(k)) != 0; }
    [[nodiscard]] double value(int k, double s) const { return at_p_[k] + s * per_s_[k]; }
    [[nodiscard]] std::optional<Passage> at_once() const;
    [[nodiscard]] bool find_start();
    [[nodiscard]] double likely_exit() const;
    [[nodiscard]] bool stays(int k, double s) const;
    [[nodiscard]] bool is_crossed(int k, double s) const;
    [[nodiscard]] bool reaches(const PrismoidPoint& end);
    [[nodiscard]] std::optional<Passage> exit_before(double s);
    [[nodiscard]] Range where(int k) const;
    [[nodiscard]] Range displacement_at(const Range& s) const;
    [[nodiscard]] Range narrowed(int k, const Range& bounds) const;

    const BaseTriangle& triangle_;
    const ScanLine& line_;
    const PrismoidPoint& from_;

    Vec3 e_;
    double t_ = 0;          ///< about the displacement of the start
    double own_ = 0;        ///< that is within this of t_
    std::array<Vec3, 3> x_; ///< the corners of the slice at t_ seen from p
    // Max norms: of e_, of x_, of the directions, of the edges of the slice, of the differences of the directions.
    double length_ = 0;
    double size_ = 0;
    double d_size_ = 0;
    double edge_ = 0;
    double divergence_ = 0;
    // w = N.e and J_i = N.d_i at t_, and their slopes in t.
    double w_ = 0;
    double w_slope_ = 0;
    std::array<double, 3> j_{};
    std::array<double, 3> j_slope_{};
    // g_k at s = 0 and its slope in s, at t_.
    std::array<double, 3> at_p_{};
    std::array<double, 3> per_s_{};
    Walls along_ = 0;       ///< those within which the line certainly runs
    Range start_{0.0, 0.0}; ///< bounds of s at the start

    // Bounds on the slices within `reach_` of t_, on which the lift is as long as it is inside the triangle and s grows
    // by no more than the way for which bound() was asked.
    double reach_ = 0;
    Range w_bounds_{};
    Range j_bounds_{};
    double rate_ = 0;  ///< |dt/ds|
    double error_ = 0; ///< of value() anywhere on the line
    double slope_ = 0; ///< of g_k in t
};

void Sweep::measure() {
    const Range bounds = from_.t.bounds();
    t_ = from_.t.approximate();
    own_ = bounds.hi - bounds.lo;
    e_ = *line_.to - *line_.from;
    length_ = max_norm(e_);
    for (int i = 0; i < 3; ++i) {
        const Vec3 x = triangle_.v[i] - *line_.from;
        size_ = std::max(size_, max_norm(x));
        d_size_ = std::max(d_size_, max_norm(triangle_.d[i]));
        x_[i] = x + t_ * triangle_.d[i];
    }
    size_ = outwards * (size_ + std::abs(t_) * d_size_);
    const Vec3 e1 = x_[1] - x_[0];
    const Vec3 e2 = x_[2] - x_[0];
    const Vec3 d1 = triangle_.d[1] - triangle_.d[0];
    const Vec3 d2 = triangle_.d[2] - triangle_.d[0];
    edge_ = std::max(max_norm(e1), max_norm(e2));
    divergence_ = outwards * std::max(max_norm(d1), max_norm(d2));
    const Vec3 n = e1.cross(e2);
    const Vec3 n_slope = d1.cross(e2) + e1.cross(d2);
    w_ = e_.dot(n);
    w_slope_ = e_.dot(n_slope);
    const Vec3 c_e = triangle_.d[0].cross(e_);
    for (int k = 0; k < 3; ++k) {
        j_[k] = triangle_.d[k].dot(n);
        j_slope_[k] = triangle_.d[k].dot(n_slope);
        const Vec3& a = x_[(k + 1) % 3];
        const Vec3& b = x_[(k + 2) % 3];
        at_p_[k] = triangle_.d[0].dot(a.cross(b));
        per_s_[k] = c_e.dot(a - b); // -c.(e x b + a x e)
        along_ |= is_on(k) && lie_across_an_axis(triangle_, k, line_) ? wall_bit(k) : 0U;
    }
}

/// Finds bounds that hold while s grows by `way`. Picard's iteration: a lift with |dt/ds| <= rate on the slices within
/// reach of t_ stays on them if own + way rate <= reach. False if there are none.
bool Sweep::bound(double way) {
    // Products of three lengths must not underflow; edge <= 2 size.
    const double least = std::min({length_, edge_, d_size_});
    if (!(least >= least_length) || !std::isfinite(own_) || !bound_rate(own_)) {
        return false;
    }
    const double growth = way * std::abs(w_slope_) / j_bounds_.lo;
    const double reach = way > 0 ? 3 * (own_ + way * rate_) / (1 - growth) : own_;
    if (!(growth < 1) || !bound_rate(reach) || !(outwards * (own_ + way * rate_) <= reach || way == 0)) {
        return false;
    }
    reach_ = reach;
    // A component of x is rounded by 4 u size; one of a product of two of them by 16 u size^2 and 4 u size^2 more, c.
    // of that by 60 + 18 u d_size size^2. In the slope in s a - b is rounded by 10 u size, and e by u length: 3 * 2 *
    // (2 * 13) u d_size length size. What is computed of both at s <= 1 adds less than 40 u.
    const double size = outwards * (size_ + length_);
    // Along t, g_k moves by ((c x d_i).x_j - (c x d_j).x_i) + c.(d_i x d_j) t, where d_i is c and a difference of
    // directions: c x d_i is 2 d_size divergence at most.
    slope_ = outwards * 12 * d_size_ * divergence_ * (size + divergence_ * reach_);
    error_ = outwards * (256 * unit_roundoff * d_size_ * size * size + slope_ * reach_);
    return true;
}

/// Bounds w, J and dt/ds on the slices within `reach` of t_. False if J may vanish there.
bool Sweep::bound_rate(double reach) {
    // An edge is rounded by 10 u size, and edge <= 2 size; a component of N by the products of two edges by 4 (10 u
    // size) edge + 4 u edge^2 <= 48 u size edge; and another 20 u size edge in the product with a vector of three
    // components. The slopes have one difference of directions in place of an edge, rounded by u times it: 3 * 2 *
    // (2 * 11 u size + 6 u edge) divergence. The rest of the series is 6 divergence^2 reach^2.
    const double rounding = 256 * unit_roundoff * size_ * edge_ + 512 * unit_roundoff * size_ * divergence_ * reach +
                            6 * divergence_ * divergence_ * reach * reach;
    const auto around = [&](double value, double slope, double factor) {
        const double error = outwards * (std::abs(slope) * reach + factor * rounding);
        return Range{value - error, value + error};
    };
    w_bounds_ = around(w_, w_slope_, length_);
    j_bounds_ = around(j_[0], j_slope_[0], d_size_);
    for (int i = 1; i < 3; ++i) {
        const Range j = around(j_[i], j_slope_[i], d_size_);
        j_bounds_ = {std::min(j_bounds_.lo, j.lo), std::max(j_bounds_.hi, j.hi)};
    }
    j_bounds_ = {j_bounds_.lo / outwards, j_bounds_.hi * outwards};
    rate_ = outwards * std::max(-w_bounds_.lo, w_bounds_.hi) / j_bounds_.lo;
    return j_bounds_.lo > 0 && std::isfinite(rate_);
}

/// The line starts on a wall and leaves through it: g_k is zero there and falls, whatever t does.
std::optional<Passage> Sweep::at_once() const {
    const double doubt = outwards * (2 * error_ + slope_ * rate_);
    int wall = -1;
    for (int k = 0; k < 3; ++k) {
        if (!is_on(k) || is_along(k) || per_s_[k] > doubt) {
            continue;
        }
        if (wall >= 0 || !(per_s_[k] < -doubt)) {
            return std::nullopt;
        }
        wall = k;
    }
    return wall < 0 ? std::nullopt : std::optional(Passage{Passage::Kind::leaves, wall, from_.t});
}

/// Where on the line the start is: one that lies on a wall has g_k = 0 there. False if that is not sure enough.
bool Sweep::find_start() {
    if (from_.walls == along_) {
        return true; // it has come through no wall: it is the first point of the line
    }
    start_ = {0.0, 1.0};
    for (int k = 0; k < 3; ++k) {
        if (is_on(k) && !is_along(k) && per_s_[k] > 4 * error_) {
            start_.lo = std::max(start_.lo, (-at_p_[k] - error_) / per_s_[k] / outwards);
            start_.hi = std::min(start_.hi, (-at_p_[k] + error_) / per_s_[k] * outwards);
        }
    }
    return start_.lo <= start_.hi && start_.hi - start_.lo < 0.5;
}

/// About the first s at which the line leaves; beyond 1 if it does not.
double Sweep::likely_exit() const {
    double s = 2;
    for (int k = 0; k < 3; ++k) {
        if (!is_on(k) && per_s_[k] < 0) {
            s = std::min(s, -at_p_[k] / per_s_[k]);
        }
    }
    return std::max(s, start_.hi);
}

/// Whether alpha_k > 0 from the start on up to s, or is zero all the way.
bool Sweep::stays(int k, double s) const {
    if (is_along(k)) {
        return true;
    }
    if (is_on(k)) { // in proportion to the way: that of value(), less that by which t moves it
        return value(k, s) - outwards * (4 * error_ + slope_ * rate_ * (s - start_.lo)) > 0;
    }
    return std::min(value(k, start_.lo), value(k, s)) - error_ > 0;
}

/// Whether alpha_k falls all the way to below 0 at s.
bool Sweep::is_crossed(int k, double s) const {
    return value(k, s) + error_ < 0 && per_s_[k] + outwards * (2 * error_ + slope_ * rate_) < 0;
}

/// Whether the line certainly stays inside until it is at the end. An end on walls is left backwards: the lift from
/// there stays on the slices too, and away from those walls. It meets the lift from the start half-way, where both are
/// inside, and a point has one place.
bool Sweep::reaches(const PrismoidPoint& end) {
    const double way = 1 - start_.lo;
    if (!bound(way)) {
        return false;
    }
    for (int k = 0; k < 3; ++k) {
        const bool ends_on = (end.walls & wall_bit(k)) != 0 && !is_along(k);
        const double before = value(k, start_.lo) - outwards * (error_ + slope_ * rate_ * way);
        if (ends_on ? is_on(k) || !((1 - start_.hi) * before > 4 * error_) : !stays(k, 1)) {
            return false;
        }
    }
    const Range at_end = end.t.bounds();
    const Range there = displacement_at({1.0, 1.0});
    if (at_end.hi < there.lo || at_end.lo > there.hi) {
        return false; // no end of this line
    }
    return outwards * (std::max(at_end.hi - t_, t_ - at_end.lo) + way * rate_) <= reach_;
}

/// Where g_k vanishes, for a wall that is crossed.
Range Sweep::where(int k) const {
    return {(at_p_[k] - error_) / -per_s_[k] / outwards, (at_p_[k] + error_) / -per_s_[k] * outwards};
}

Range Sweep::displacement_at(const Range& s) const {
    const UpwardRounding upward;
    const Range from = from_.t.bounds();
    const Interval way = Interval(s.lo, s.hi) - Interval(start_.lo, start_.hi);
    const Interval rate = Interval(w_bounds_.lo, w_bounds_.hi) / Interval(j_bounds_.lo, j_bounds_.hi);
    const Interval t = Interval(from.lo, from.hi) + Interval(std::max(0.0, way.inf()), way.sup()) * rate;
    return {t.inf(), t.sup()};
}

/// Newton's step from the middle of the bounds of a root of side_k(t) = e.((a_i(t) - p) x (a_j(t) - p)). Where the
/// line crosses a wall its slope is that of alpha_k in s times J: never near zero, however flat the part.
Range Sweep::narrowed(int k, const Range& bounds) const {
    const double middle = bounds.lo + 0.5 * (bounds.hi - bounds.lo);
    const Vec3& d_i = triangle_.d[(k + 1) % 3];
    const Vec3& d_j = triangle_.d[(k + 2) % 3];
    const Vec3 a = x_[(k + 1) % 3] + (middle - t_) * d_i;
    const Vec3 b = x_[(k + 2) % 3] + (middle - t_) * d_j;
    const double value = e_.dot(a.cross(b));
    const double slope = e_.dot(d_i.cross(b) + a.cross(d_j));
    // As in bound_rate(), with `size` for the edges. The slope moves by 2 e.(d_i x d_j) times the way.
    const double way = bounds.hi - bounds.lo;
    const double size = outwards * (size_ + (reach_ + way) * d_size_);
    const double error = 256 * unit_roundoff * length_ * size * size;
    const double slope_error = length_ * d_size_ * (256 * unit_roundoff * size + outwards * 12 * divergence_ * way);
    if (!(std::abs(slope) > 2 * slope_error)) {
        return bounds;
    }
    const UpwardRounding upward;
    const Interval step = Interval(-value - error, -value + error) / Interval(slope - slope_error, slope + slope_error);
    const Interval root = Interval(middle) + step;
    return {std::max(bounds.lo, root.inf()), std::min(bounds.hi, root.sup())};
}

/// The wall through which the line leaves before s, if it is sure which is the first.
std::optional<Passage> Sweep::exit_before(double s) {
    if (!bound(s - start_.lo)) {
        return std::nullopt;
    }
    int first = -1;
    bool is_clear = true;
    Range exit{1.0, 1.0};
    for (int k = 0; k < 3; ++k) {
        if (stays(k, s)) {
            continue;
        }
        if (is_on(k) || !is_crossed(k, s)) {
            return std::nullopt;
        }
        const Range here = where(k);
        is_clear = first < 0 || here.hi < exit.lo || (is_clear && exit.hi < here.lo);
        if (first < 0 || here.lo < exit.lo) {
            first = k;
            exit = here;
        }
    }
    if (first < 0 || !is_clear) {
        return std::nullopt;
    }
    const Range bounds = narrowed(first, displacement_at(exit));
    if (!std::isfinite(bounds.lo) || !std::isfinite(bounds.hi)) {
        return std::nullopt;
    }
    const Passage::Kind kind = along_ == 0 ? Passage::Kind::leaves : Passage::Kind::pillar;
    return Passage{kind, first, Displacement::at_wall(triangle_, first, line_, bounds)};
}

std::optional<Passage> Sweep::passage(const PrismoidPoint* end) {
    if (!bound(0)) {
        return std::nullopt;
    }
    if (std::optional<Passage> out = at_once()) {
        return out;
    }
    // Where t moves much, its bounds along the way hide all walls (see exit_before): intervals in t are better there.
    const double steepest = std::max({std::abs(per_s_[0]), std::abs(per_s_[1]), std::abs(per_s_[2])});
    if (24 * slope_ * rate_ > steepest || !find_start()) {
        return std::nullopt;
    }
    const double exit = likely_exit();
    if (exit >= 1) {
        return end != nullptr && reaches(*end) ? std::optional(Passage{Passage::Kind::ends, -1, end->t}) : std::nullopt;
    }
    // A little further, so that it is certainly outside there.
    return exit_before(std::min(1.0, exit + 0.125 * (exit - start_.lo)));
}

} // namespace

std::optional<Passage> filtered_passage(const BaseTriangle& triangle, const ScanLine& line, const PrismoidPoint& from,
                                        const PrismoidPoint* end) {
    return Sweep(triangle, line, from).passage(end);
}

} // namespace foldless
