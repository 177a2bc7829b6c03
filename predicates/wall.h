/// \file
/// The wall of a base edge (i, j): the ruled surface of all (1 - lambda) a_i(t) + lambda a_j(t), through which edges of
/// the scan pass from one prismoid to its neighbour.
///
///          a_i(t) ---------- a_j(t)        lambda from 0 at i to 1 at j,
///            |                 |           t upwards along the displacement directions;
///            |      wall       |           seen from the triangle that has i before j in its orientation,
///           v_i ------------- v_j          the wall's normal points outwards.
#pragma once

#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <optional>

namespace foldless {

/// The wall of one base edge, with cached products.
class Wall {
public:
    /// The wall from corner i = (k + 1) mod 3 to corner j = (k + 2) mod 3 of the triangle: the one opposite corner k.
    Wall(const BaseTriangle& triangle, int opposite);

    /// A crossing of the scan edge from `a` along `e` with the wall.
    struct Crossing {
        double s;      ///< position on the edge, 0 at a, 1 at a + e
        double lambda; ///< position on the base edge, 0 at i, 1 at j
        double t;      ///< displacement
        double error;  ///< bound on the error of s and of lambda
        double t_error;
    };

    /// The sign of e.((a_j - a_i)(t) x d(lambda)), one for all lambda in [0, 1] and t in `range`: positive if the
    /// direction e passes outwards through every such point of the wall, negative if inwards, undecided if it is
    /// neither or rounding hides it. Where it is decided, a straight line along e meets that part of the wall at most
    /// once: the map (s, lambda, t) -> point has this sign as its Jacobian and degree 2, so it is injective
    /// (docs/certificate.md).
    [[nodiscard]] Sign passes(const Vec3& e, Range range) const;

    /// The same sign at one point of the wall, lambda and t being known up to the errors.
    [[nodiscard]] Sign passes_at(const Vec3& e, const Crossing& at) const;

    /// The same sign at the pillar of corner i (lambda = 0) or of corner j (lambda = 1), at t = 0.
    [[nodiscard]] Sign passes_at_corner(const Vec3& e, int lambda) const;

    /// For a scan edge along e with one end at corner i (lambda = 0) or j (lambda = 1) of the wall, at t = 0: whether
    /// it certainly meets the wall nowhere else at a displacement in `range`. The quadratic e.((a_i - q) x (a_j - q))
    /// has the root 0 then; divided by t it is linear, and must not vanish.
    [[nodiscard]] bool met_only_at_corner(const Vec3& e, int lambda, Range range) const;

    /// Whether the line through `a` along `e` certainly meets the wall at no displacement in `range`, or at no more
    /// than one. It meets it only where side(t) = e.((a_i - a) x (a_j - a)) vanishes: never if the Bernstein
    /// coefficients of that quadratic have one sign, once at most if its slope has. Blind where the line lies in a
    /// slice, for then side(t) is zero; that is where passes() sees best.
    [[nodiscard]] bool misses(const Vec3& a, const Vec3& e, Range range) const;
    [[nodiscard]] bool meets_once_at_most(const Vec3& a, const Vec3& e, Range range) const;

    /// Which crossings are asked for.
    struct Wanted {
        Range range;        ///< of displacements
        bool outwards_only; ///< not those where e certainly passes inwards
    };

    /// The crossings with 0 <= s <= 1 and 0 <= lambda <= 1 and t in range, each up to rounding and proven to exist
    /// within its errors; at most two. One that cannot be proven is reported with an infinite error. (s, lambda, t) is
    /// the inverse displacement of a on the triangle (v_i, v_j, v_i - e) with directions (d_i, d_j, d_i), whose cubic
    /// is a quadratic.
    struct Crossings {
        std::array<Crossing, 2> values;
        int count = 0;
    };
    [[nodiscard]] Crossings crossings(const Vec3& a, const Vec3& e, const Wanted& wanted) const;

private:
    struct Side;
    [[nodiscard]] std::optional<Crossing> crossing_at(const Vec3& a, const Vec3& e, double t,
                                                      const Wanted& wanted) const;
    [[nodiscard]] Side side(const Vec3& a, const Vec3& e) const;

    Vec3 v_i_, v_j_, d_i_, d_j_;
    Vec3 r_, delta_;                        ///< v_j - v_i and d_j - d_i
    Vec3 w0_, w1_, w2_;                     ///< the normal is w0 + lambda w1 + t w2
    double d_i_size_, r_size_, delta_size_; ///< largest components
    double size_, spread_;
};

/// A part of a scan edge: from one point to another, each known up to `error` in every coordinate.
struct EdgePart {
    Vec3 from;
    Vec3 to;
    double error;
};

/// The part of the edge from `a` along `e` between the positions s0 <= s1, which are known up to `s_error`.
[[nodiscard]] EdgePart part_of_edge(const Vec3& a, const Vec3& e, const std::array<double, 2>& s, double s_error);

/// Whether the part certainly never meets the wall opposite corner k of the triangle at a displacement in `range`, by
/// the sign of det(a_i - q, a_j - q, c) over it, c being the mean direction: that determinant is alpha_k times N.c on a
/// slice. A sufficient test for edges that run along a wall beside it.
[[nodiscard]] bool stays_off_wall(const BaseTriangle& triangle, int opposite, const EdgePart& part, Range range);

} // namespace foldless
