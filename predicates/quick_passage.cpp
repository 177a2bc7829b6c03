#include <foldless/predicates/quick_passage.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

using Quadratic = LineSides::Quadratic;

double value_at(const Quadratic& c, double t) {
    return (c[2] * t + c[1]) * t + c[0];
}
double slope_at(const Quadratic& c, double t) {
    return c[1] + 2 * c[2] * t;
}

/// A displacement between two doubles, and one in between.
struct Near {
    explicit Near(const Displacement& displacement)
        : bounds(displacement.bounds()), t(bounds.lo), width(bounds.hi - bounds.lo) {}

    Range bounds;
    double t;
    double width;
};

class Line {
public:
    Line(const LineInPrismoid& way, const LineSides& sides) : way_(way), sides_(sides), start_(way.from.t) {}

    [[nodiscard]] std::optional<Passage> passage();

private:
    [[nodiscard]] bool is_on(int k) const { return (way_.from.walls & wall_bit(k)) != 0; }
    [[nodiscard]] bool ends_on(int k) const { return (way_.end->walls & wall_bit(k)) != 0; }

    // A side has six products of size e X^2 at most, where X = x + |t| d. With u the rounding, its coefficients are off
    // by 64 u e X^2 in all, and Horner's rule adds 4 u on those products; for the slope the same with 2 e X d.
    [[nodiscard]] double reach(double t) const { return sides_.x_size + std::abs(t) * sides_.d_size; }
    [[nodiscard]] double error_at(double t) const { return 2 * sides_.unit * reach(t) * reach(t); }
    [[nodiscard]] double slope_error_at(double t) const { return 4 * sides_.unit * reach(t) * sides_.d_size; }
    /// By how much the value moves where t is off by a width.
    [[nodiscard]] static double moves(const Quadratic& c, double t, double width) {
        return (std::abs(slope_at(c, t)) + std::abs(c[2]) * width) * width;
    }

    /// Of w at the start.
    [[nodiscard]] double rise_error() const {
        return 4 * error_at(start_.t) + 2 * moves(sides_.rise, start_.t, start_.width);
    }

    [[nodiscard]] bool is_finite_until(double t) const {
        const double x = reach(t) + sides_.d_size;
        return std::isfinite(16 * sides_.e_size * x * x) && std::isfinite(sides_.unit);
    }
    [[nodiscard]] bool ends_before_any_wall(const Near& end);
    [[nodiscard]] bool meets_no_wall(int k, const Near& end, bool ends_on_it) const;
    [[nodiscard]] std::optional<Passage> exit();
    [[nodiscard]] double likely_exit(int k) const;
    [[nodiscard]] std::optional<Range> crossing_near(int k, double t) const;
    [[nodiscard]] bool comes_before_the_end(const Range& crossing) const;

    const LineInPrismoid& way_;
    const LineSides& sides_;
    Near start_;
    int direction_ = 0; ///< 1 if the displacement grows along the lift, -1 if it falls
};

std::optional<Passage> Line::passage() {
    if (!is_finite_until(std::max(std::abs(start_.bounds.lo), std::abs(start_.bounds.hi)))) {
        return std::nullopt;
    }
    if (way_.end != nullptr && ends_before_any_wall(Near(way_.end->t))) {
        return Passage{Passage::Kind::ends, -1, way_.end->t};
    }
    return exit();
}

/// Whether the line certainly reaches its end in this prismoid: nearly always if it does.
bool Line::ends_before_any_wall(const Near& end) {
    const Range& a = start_.bounds;
    const Range& b = end.bounds;
    if (a.hi >= b.lo && b.hi >= a.lo) {
        return false;
    }
    direction_ = a.hi < b.lo ? 1 : -1;
    return is_finite_until(std::max(std::abs(b.lo), std::abs(b.hi))) &&
           direction_ * value_at(sides_.rise, start_.t) > rise_error() && meets_no_wall(0, end, ends_on(0)) &&
           meets_no_wall(1, end, ends_on(1)) && meets_no_wall(2, end, ends_on(2));
}

/// Whether side_k direction stays positive between the start and the end, beside known roots there: a sufficient test.
bool Line::meets_no_wall(int k, const Near& end, bool ends_on_it) const {
    const Quadratic& c = sides_.sides[k];
    const double t0 = start_.t;
    const double t1 = end.t;
    const double furthest = std::max(std::abs(t0), std::abs(t1));
    // What the widths of both ends move is counted twice over, for the second order.
    if (is_on(k) && ends_on_it) { // c2 (t - start) (t - end)
        return direction_ * c[2] < -sides_.unit * sides_.d_size * sides_.d_size;
    }
    if (is_on(k) || ends_on_it) {
        const double error = slope_error_at(furthest) + 4 * std::abs(c[2]) * (start_.width + end.width);
        if (is_on(k)) { // (t - start) (c1 + c2 (t + start)), the first factor has the sign of the direction
            return slope_at(c, t0) > error && c[1] + c[2] * (t0 + t1) > error;
        }
        // (t - end) (c1 + c2 (t + end)), the first factor has the opposite sign
        return slope_at(c, t1) < -error && c[1] + c[2] * (t0 + t1) < -error;
    }
    // The Bernstein coefficients between both.
    const double error = error_at(furthest);
    const double at_start = direction_ * value_at(c, t0);
    const double at_end = direction_ * value_at(c, t1);
    const double middle = direction_ * (c[0] + 0.5 * c[1] * (t0 + t1) + c[2] * t0 * t1);
    const double of_start = 2 * moves(c, t0, start_.width);
    const double of_end = 2 * moves(c, t1, end.width);
    const double of_middle =
        2 * (std::abs(0.5 * c[1] + c[2] * t1) * start_.width + std::abs(0.5 * c[1] + c[2] * t0) * end.width +
             std::abs(c[2]) * start_.width * end.width);
    return at_start > error + of_start && middle > error + of_middle && at_end > error + of_end;
}

/// Where the line leaves, if it certainly meets the wall that it most likely meets first, and none before.
std::optional<Passage> Line::exit() {
    const double rise = value_at(sides_.rise, start_.t);
    if (!(std::abs(rise) > rise_error())) {
        return std::nullopt;
    }
    direction_ = rise > 0 ? 1 : -1;
    const std::array<double, 3> t{likely_exit(0), likely_exit(1), likely_exit(2)};
    int wall = 0;
    for (int k = 1; k < 3; ++k) {
        wall = direction_ * (t[k] - t[wall]) < 0 ? k : wall;
    }
    const std::optional<Range> crossing = std::isfinite(t[wall]) ? crossing_near(wall, t[wall]) : std::nullopt;
    if (!crossing || !comes_before_the_end(*crossing)) {
        return std::nullopt;
    }
    // Along the lift: just before the crossing, and just after it.
    const Near before{Displacement(direction_ > 0 ? crossing->lo : crossing->hi)};
    const Near after{Displacement(direction_ > 0 ? crossing->hi : crossing->lo)};
    for (int k = 0; k < 3; ++k) {
        if (!meets_no_wall(k, k == wall ? before : after, false)) {
            return std::nullopt;
        }
    }
    return Passage{Passage::Kind::leaves, wall, Displacement::at_wall(way_.triangle, wall, way_.line, *crossing)};
}

/// Whether it lies certainly ahead, and the end of the line, if that is in this prismoid, beyond it or behind the
/// start.
bool Line::comes_before_the_end(const Range& crossing) const {
    const Range& from = start_.bounds;
    if (!(direction_ > 0 ? from.hi < crossing.lo : crossing.hi < from.lo)) {
        return false;
    }
    if (way_.end == nullptr) {
        return true;
    }
    const Range end = way_.end->t.bounds();
    return direction_ > 0 ? end.hi < from.lo || crossing.hi < end.lo : from.hi < end.lo || end.hi < crossing.lo;
}

/// About the first displacement ahead at which side_k vanishes; infinitely far ahead if there is none.
double Line::likely_exit(int k) const {
    const Quadratic& c = sides_.sides[k];
    const double discriminant = c[1] * c[1] - 4 * c[0] * c[2];
    double first = std::numeric_limits<double>::infinity();
    if (is_on(k) || !(discriminant >= 0)) {
        return direction_ * first;
    }
    const double h = -0.5 * (c[1] + std::copysign(std::sqrt(discriminant), c[1]));
    for (const double root : {h / c[2], c[0] / h}) {
        const double ahead = direction_ * (root - start_.t);
        first = ahead > 0 && ahead < first ? ahead : first;
    }
    return start_.t + direction_ * first;
}

/// Close bounds around t at which side_k certainly falls from one sign to the other, along the lift.
std::optional<Range> Line::crossing_near(int k, double t) const {
    const Quadratic& c = sides_.sides[k];
    // Inside, side_k direction is positive. Along the lift t direction grows: its slope is that of side_k over t.
    const double slope = slope_at(c, t) + slope_error_at(t);
    if (!(slope < 0)) {
        return std::nullopt;
    }
    const double way = 2 * (std::abs(value_at(c, t)) + error_at(t)) / -slope;
    const Range bounds{t - way, t + way};
    const double furthest = std::max(std::abs(bounds.lo), std::abs(bounds.hi));
    const double error = error_at(furthest);
    const bool falls = value_at(c, bounds.lo) > error && value_at(c, bounds.hi) < -error;
    return falls && is_finite_until(furthest) ? std::optional(bounds) : std::nullopt;
}

} // namespace

std::optional<Passage> quick_passage(const LineInPrismoid& way, const LineSides& sides) {
    return Line(way, sides).passage();
}

} // namespace foldless
