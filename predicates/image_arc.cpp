#include <foldless/predicates/image_arc.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/prismoid_polynomials.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace foldless {
namespace {

using IntervalVec = VectorOf<Interval>;

Interval hull(const Interval& a, const Interval& b) {
    return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}
double width(const Interval& x) {
    return x.sup() - x.inf();
}
bool are_disjoint(const Interval& a, const Interval& b) {
    return a.sup() < b.inf() || b.sup() < a.inf();
}

/// Both; \pre they have a point in common
Interval intersection(const Interval& a, const Interval& b) {
    return {std::max(a.inf(), b.inf()), std::min(a.sup(), b.sup())};
}

/// Barycentric coordinates.
using Alpha = std::array<Interval, 3>;

/// A point of the arc: bounds of the parameter of the line, of the displacement and of alpha.
struct ArcPoint {
    Interval s;
    Interval t;
    Alpha alpha;
};

/// A piece of an arc: t is monotone from one end to the other (lemma L4).
struct Piece {
    ArcPoint from;
    ArcPoint to;
    Alpha alpha; ///< a box around it

    [[nodiscard]] double size() const { return std::max({width(alpha[0]), width(alpha[1]), width(alpha[2])}); }
};

} // namespace

/// The line p + s e in the prismoid. Upward rounding must be on for all of its functions.
class ImageArc::Curve {
public:
    Curve(const BaseTriangle& triangle, const ScanLine& line, const End& from, const End& to)
        : p_(exactly<Interval>(*line.from)), e_(exactly<Interval>(*line.to) - p_),
          cubic_(cubic<Interval>(triangle, *line.from)), rise_(rise<Interval>(triangle, line)) {
        for (int i = 0; i < 3; ++i) {
            v_[i] = exactly<Interval>(triangle.v[i]);
            d_[i] = exactly<Interval>(triangle.d[i]);
        }
        whole_.from = point(from, Interval(0));
        whole_.to = point(to, Interval(1));
        whole_.alpha = box(whole_);
    }

    [[nodiscard]] const Piece& whole() const { return whole_; }

    /// The derivative of (alpha_1, alpha_2) along the line, times J > 0, over the piece.
    [[nodiscard]] std::array<Interval, 2> direction(const Piece& piece) const {
        const Interval t = hull(piece.from.t, piece.to.t);
        const IntervalVec a0 = corner_at(0, t);
        const IntervalVec d = direction_at(piece.alpha);
        return {dot(e_, cross(corner_at(2, t) - a0, d)), dot(e_, cross(d, corner_at(1, t) - a0))};
    }

    /// Two parts, or nothing if doubles do not tell their ends apart.
    [[nodiscard]] std::optional<std::array<Piece, 2>> parts(const Piece& piece) const {
        const std::optional<ArcPoint> middle = middle_of(piece);
        if (!middle) {
            return std::nullopt;
        }
        std::array<Piece, 2> result{Piece{piece.from, *middle, {}}, Piece{*middle, piece.to, {}}};
        for (Piece& part : result) {
            part.alpha = box(part);
        }
        return result;
    }

    /// The point of the piece at s. \pre s is between its ends
    [[nodiscard]] ArcPoint point_at(double s, const Piece& piece) const {
        // Newton's steps, within the bounds that monotony gives.
        Interval t = hull(piece.from.t, piece.to.t);
        for (int step = 0; step < 4; ++step) {
            const double middle = t.inf() + 0.5 * (t.sup() - t.inf());
            const Interval slope = slope_at(s, t);
            if (!(slope.inf() > 0)) {
                break;
            }
            const Interval next = Interval(middle) - value_of(s, Interval(middle)) / slope;
            if (are_disjoint(next, t)) {
                break;
            }
            t = intersection(next, t);
        }
        return at(Interval(s), t);
    }

    /// A box around alpha at a point or between two.
    [[nodiscard]] Alpha alpha_at(const Interval& s, const Interval& t) const {
        // alpha_k N.c = c.((a_i - q) x (a_j - q)) with a direction of the triangle for c, around the middle of both:
        // all directions are much like c, so that the terms in tau, with c x d, are small.
        const Interval middle_s(s.inf() + 0.5 * (s.sup() - s.inf()));
        const Interval middle_t(t.inf() + 0.5 * (t.sup() - t.inf()));
        const Interval sigma = s - middle_s;
        const Interval tau = t - middle_t;
        const IntervalVec q = p_ + middle_s * e_;
        const IntervalVec& c = d_[0];
        std::array<IntervalVec, 3> x;
        std::array<IntervalVec, 3> c_d;
        for (int i = 0; i < 3; ++i) {
            x[i] = corner_at(i, middle_t) - q;
            c_d[i] = cross(c, d_[i]);
        }
        const IntervalVec c_e = cross(c, e_);
        Alpha alpha;
        Interval scale(0);
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3;
            const int j = (k + 2) % 3;
            const Interval at_middle = dot(c, cross(x[i], x[j]));
            const Interval per_t = dot(c_d[i], x[j]) - dot(c_d[j], x[i]);
            const Interval per_tt = dot(c_d[i], d_[j]);
            scale += at_middle + tau * (per_t + tau * per_tt);
            alpha[k] = at_middle + sigma * dot(c_e, x[i] - x[j]) +
                       tau * (per_t - sigma * dot(c_d[i] - c_d[j], e_) + tau * per_tt);
        }
        for (Interval& x_k : alpha) {
            x_k = x_k / scale; // N.c is the sum of all three, wherever q is
        }
        return alpha;
    }

    [[nodiscard]] IntervalVec position_at(double s) const { return p_ + Interval(s) * e_; }
    [[nodiscard]] IntervalVec direction_at(const Alpha& alpha) const {
        return alpha[0] * d_[0] + alpha[1] * d_[1] + alpha[2] * d_[2];
    }

private:
    [[nodiscard]] IntervalVec corner_at(int i, const Interval& t) const { return v_[i] + t * d_[i]; }

    [[nodiscard]] ArcPoint at(const Interval& s, const Interval& t) const { return {s, t, alpha_at(s, t)}; }

    [[nodiscard]] Alpha box(const Piece& piece) const {
        Alpha alpha = alpha_at(hull(piece.from.s, piece.to.s), hull(piece.from.t, piece.to.t));
        for (Interval& x : alpha) { // the arc is in the triangle
            const Interval within(0, 1);
            x = are_disjoint(x, within) ? x : intersection(x, within);
        }
        return alpha;
    }

    /// A point that halves s; or t, as long as that hides where s is.
    [[nodiscard]] std::optional<ArcPoint> middle_of(const Piece& piece) const {
        const double lo = piece.from.s.sup();
        const double hi = piece.to.s.inf();
        const double s = lo + 0.5 * (hi - lo);
        if (!(lo < s && s < hi)) {
            return std::nullopt;
        }
        const ArcPoint at_s = point_at(s, piece);
        const Interval t = hull(piece.from.t, piece.to.t);
        if (width(at_s.t) <= 0.5 * width(t)) {
            return at_s;
        }
        const double middle = t.inf() + 0.5 * (t.sup() - t.inf());
        const bool is_passed = std::min(piece.from.t.sup(), piece.to.t.sup()) < middle &&
                               middle < std::max(piece.from.t.inf(), piece.to.t.inf());
        if (!is_passed) { // the ends are not known well enough: the lift may have no point in that slice
            return at_s;
        }
        const Interval at_t = value_at(cubic_, Interval(middle)) / value_at(rise_, Interval(middle));
        return at_t.inf() > lo && at_t.sup() < hi ? at(at_t, Interval(middle)) : at_s;
    }

    [[nodiscard]] ArcPoint point(const End& end, const Interval& s_of_line) const {
        const Range t = end.at.t.bounds();
        const Interval in(t.lo, t.hi);
        if (end.is_of_line) {
            return at(s_of_line, in);
        }
        // The line is in the slice where C_p - s w vanishes, unless it is in there all the way; and on the wall where
        // c.((a_i - p - s e) x (a_j - p - s e)) does, for any c.
        Interval s(0, 1);
        const auto narrow = [&](const Interval& root) { s = are_disjoint(s, root) ? s : intersection(s, root); };
        narrow(value_at(cubic_, in) / value_at(rise_, in));
        const int wall = std::countr_zero(end.at.walls);
        const IntervalVec a = corner_at((wall + 1) % 3, in) - p_;
        const IntervalVec b = corner_at((wall + 2) % 3, in) - p_;
        const IntervalVec a_b = cross(a, b);
        const IntervalVec e_ab = cross(e_, b - a);
        for (const IntervalVec& c : d_) {
            narrow(dot(c, a_b) / dot(c, e_ab));
        }
        return at(s, in);
    }

    /// C_q(t) of the point q at s of the line, and its derivative. (lemma L4)
    [[nodiscard]] Interval value_of(double s, const Interval& t) const {
        return value_at(cubic_, t) - Interval(s) * value_at(rise_, t);
    }
    [[nodiscard]] Interval slope_at(double s, const Interval& t) const {
        return (3 * cubic_[3] * t + 2 * cubic_[2]) * t + cubic_[1] - Interval(s) * (2 * rise_[2] * t + rise_[1]);
    }

    IntervalVec p_;
    IntervalVec e_;
    std::array<IntervalVec, 3> v_;
    std::array<IntervalVec, 3> d_;
    Coefficients<Interval, 4> cubic_;
    Coefficients<Interval, 3> rise_;
    Piece whole_;
};

ImageArc::ImageArc(const BaseTriangle& triangle, const ScanLine& line, const End& from, const End& to) {
    const UpwardRounding upward;
    curve_ = std::make_unique<Curve>(triangle, line, from, to);
}
Range ImageArc::bounds(int k) const {
    return {curve_->whole().alpha[k].inf(), curve_->whole().alpha[k].sup()};
}
Range ImageArc::parameters() const {
    return {curve_->whole().from.s.sup(), curve_->whole().to.s.inf()};
}
ImageArc::ImageArc(ImageArc&&) noexcept = default;
ImageArc& ImageArc::operator=(ImageArc&&) noexcept = default;
ImageArc::~ImageArc() = default;

namespace {

using Curve = ImageArc::Curve;

/// One of two arcs, a piece of it, and the end at which the piece still has the shared point.
struct Part {
    const Curve* curve;
    Piece piece;
    SharedEnd shared;

    /// The direction away from the shared point.
    [[nodiscard]] std::array<Interval, 2> away() const {
        const std::array<Interval, 2> u = curve->direction(piece);
        return shared == SharedEnd::to ? std::array<Interval, 2>{-u[0], -u[1]} : u;
    }
};

/// A plane vector of (alpha_1, alpha_2).
template <class Number>
using Plane = std::array<Number, 2>;

/// A thin box along the chord of a piece: p + along c + across n, with n at right angles to c.
struct Sliver {
    Plane<Interval> p;
    Plane<double> c;
    Interval along;
    Interval across;

    [[nodiscard]] Plane<double> normal() const { return {-c[1], c[0]}; }
    [[nodiscard]] Interval extent(const Plane<double>& m) const {
        const auto times_m = [&](const auto& v) { return Interval(m[0]) * v[0] + Interval(m[1]) * v[1]; };
        return times_m(p) + along * times_m(c) + across * times_m(normal());
    }
};

/// If the piece runs forwards along its chord everywhere: then its way across is at most that times the steepest
/// direction, which is of the second order in its length.
std::optional<Sliver> sliver_around(const Part& part) {
    const auto middle = [](const Interval& x) { return x.inf() + 0.5 * (x.sup() - x.inf()); };
    const Alpha& from = part.piece.from.alpha;
    const Alpha& to = part.piece.to.alpha;
    Sliver sliver{{from[1], from[2]}, {middle(to[1]) - middle(from[1]), middle(to[2]) - middle(from[2])}, {}, {}};
    const Plane<double>& c = sliver.c;
    const Plane<Interval> u = part.curve->direction(part.piece);
    const Interval forwards = u[0] * c[0] + u[1] * c[1];
    const Interval sideways = u[1] * c[0] - u[0] * c[1];
    if (!(forwards.inf() > 0)) {
        return std::nullopt;
    }
    const Interval chord = (to[1] - from[1]) * c[0] + (to[2] - from[2]) * c[1];
    sliver.along = Interval(0, (chord / (Interval(c[0]) * c[0] + Interval(c[1]) * c[1])).sup());
    sliver.across = sideways / forwards * sliver.along;
    return sliver;
}

/// Boxes on one triangle.
struct OnOneTriangle {
    [[nodiscard]] static bool are_separate(const Part& a, const Part& b) {
        for (int k = 0; k < 3; ++k) {
            if (are_disjoint(a.piece.alpha[k], b.piece.alpha[k])) {
                return true;
            }
        }
        const std::optional<Sliver> x = sliver_around(a);
        const std::optional<Sliver> y = x ? sliver_around(b) : std::nullopt;
        return y && (are_disjoint(x->extent(x->normal()), y->extent(x->normal())) ||
                     are_disjoint(x->extent(y->normal()), y->extent(y->normal())));
    }
    /// The cones of directions have only the apex in common: all pairs of directions turn the same way, or all enclose
    /// more than a right angle. (A common direction x would be a sum of directions of either cone, and x x x = 0, x.x >
    /// 0 are sums over pairs.) Which scalar product is taken does not matter.
    [[nodiscard]] static bool part_at_once(const Part& a, const Part& b) {
        const std::array<Interval, 2> u = a.away();
        const std::array<Interval, 2> v = b.away();
        const Sign turn = sign_of(u[0] * v[1] - u[1] * v[0]);
        return turn == Sign::positive || turn == Sign::negative || (u[0] * v[0] + u[1] * v[1]).sup() < 0;
    }
};

/// Boxes on two triangles, of which only what is on the wall counts.
struct OnCommonWall {
    CommonWall wall;

    [[nodiscard]] bool are_separate(const Part& a, const Part& b) const {
        return a.piece.alpha[wall.a].inf() > 0 || b.piece.alpha[wall.b].inf() > 0 ||
               are_disjoint(a.piece.alpha[(wall.a + 1) % 3], b.piece.alpha[(wall.b + 2) % 3]);
    }
    /// One of them leaves the wall.
    [[nodiscard]] bool part_at_once(const Part& a, const Part& b) const {
        return leaves(a, wall.a) || leaves(b, wall.b);
    }
    static bool leaves(const Part& part, int k) {
        const std::array<Interval, 2> u = part.away();
        return (k == 0 ? -(u[0] + u[1]) : u[k - 1]).inf() > 0;
    }
};

/// Splits the larger piece until all pairs are separate.
template <class Where>
class Separator {
public:
    explicit Separator(const Where& where) : where_(where) {}

    bool are_apart(const Part& a, const Part& b) {
        const bool shared = a.shared != SharedEnd::none;
        if (shared ? where_.part_at_once(a, b) : where_.are_separate(a, b)) {
            return true;
        }
        if (splits_ == most_splits) {
            return false;
        }
        ++splits_;
        return a.piece.size() >= b.piece.size() ? split(a, b, false) : split(b, a, true);
    }

private:
    /// Far more than arcs need that are not within rounding of each other.
    static constexpr int most_splits = 4000;

    bool split(const Part& larger, const Part& other, bool swapped) {
        const auto parts = larger.curve->parts(larger.piece);
        if (!parts) {
            return false;
        }
        for (int i = 0; i < 2; ++i) {
            const bool has_shared = larger.shared == (i == 0 ? SharedEnd::from : SharedEnd::to);
            const Part part{larger.curve, (*parts)[i], has_shared ? larger.shared : SharedEnd::none};
            Part rest = other;
            rest.shared = has_shared ? other.shared : SharedEnd::none;
            if (!(swapped ? are_apart(rest, part) : are_apart(part, rest))) {
                return false;
            }
        }
        return true;
    }

    Where where_;
    int splits_ = 0;
};

template <class Where>
bool are_apart(const Where& where, const ImageArc& a, const ImageArc& b, const SharedPoint& shared) {
    const UpwardRounding upward;
    return Separator<Where>(where).are_apart({&a.curve(), a.curve().whole(), shared.a},
                                             {&b.curve(), b.curve().whole(), shared.b});
}

} // namespace

SharedPoint shared_point(const std::array<std::int32_t, 2>& a, const std::array<std::int32_t, 2>& b) {
    constexpr std::array<SharedEnd, 2> ends{SharedEnd::from, SharedEnd::to};
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            if (a[i] >= 0 && a[i] == b[j]) {
                return {ends[i], ends[j]};
            }
        }
    }
    return {};
}

bool are_apart(const ImageArc& a, const ImageArc& b, const SharedPoint& shared) {
    return are_apart(OnOneTriangle{}, a, b, shared);
}

bool are_apart_on_wall(const ImageArc& a, const ImageArc& b, const CommonWall& wall, const SharedPoint& shared) {
    return are_apart(OnCommonWall{wall}, a, b, shared);
}

bool certainly_misses(const ImageArc& arc, double s, const ScanTriangle& triangle, Range range) {
    const UpwardRounding upward;
    const Curve& curve = arc.curve();
    const ArcPoint point = curve.point_at(s, curve.whole());
    const IntervalVec d = curve.direction_at(point.alpha);
    std::array<IntervalVec, 3> x;
    for (int i = 0; i < 3; ++i) {
        x[i] = exactly<Interval>(triangle[i]) - curve.position_at(s);
    }
    // The plane is at l + tau m = 0 with tau in range - t; the line passes all three edges on the same side if it hits.
    const IntervalVec n = cross(x[1] - x[0], x[2] - x[0]);
    const Interval l = -dot(x[0], n);
    const Interval m = dot(d, n);
    const Sign at_lo = sign_of(l + (Interval(range.lo) - point.t) * m);
    const Sign at_hi = sign_of(l + (Interval(range.hi) - point.t) * m);
    if (at_lo == at_hi && (at_lo == Sign::positive || at_lo == Sign::negative)) {
        return true;
    }
    bool is_left = false;
    bool is_right = false;
    for (int i = 0; i < 3; ++i) {
        const Sign side = sign_of(dot(d, cross(x[i], x[(i + 1) % 3])));
        is_left = is_left || side == Sign::positive;
        is_right = is_right || side == Sign::negative;
    }
    return is_left && is_right;
}

} // namespace foldless
