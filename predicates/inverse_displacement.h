/// \file
/// The inverse barycentric displacement problem: which point of a base triangle, moved along its interpolated
/// direction, reaches a given point?
#pragma once

#include <foldless/predicates/cubic_roots.h>
#include <foldless/predicates/rounding.h>
#include <foldless/predicates/vector.h>

#include <array>
#include <optional>

namespace foldless {

/// A solution (alpha, t) of q = sum alpha_i (v_i + t d_i).
struct Preimage {
    Vec3 alpha;   ///< barycentric coordinates; their sum is 1, their signs are free
    double t;     ///< displacement, in units of the interpolated direction
    double slope; ///< J(alpha, t) = N(t) . d(alpha), the slope of the cubic at t; > 0 where the map does not fold
};

/// Whether the solution lies in the base triangle, its border included.
[[nodiscard]] inline bool inside(const Preimage& preimage) {
    return preimage.alpha.minCoeff() >= 0.0;
}

/// The solutions of one point in ascending order of t: at most three, held without allocation.
class Preimages {
public:
    enum class Kind {
        none,     ///< no (alpha, t) reaches the point
        finite,   ///< the listed solutions are all
        infinite, ///< a slice shrinks to a line or point that holds q, or q lies in every slice, or no double holds a
                  ///< solution: the list is not all
    };

    Kind kind = Kind::none;

    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const Preimage& operator[](int i) const { return list_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const Preimage* begin() const { return list_.data(); }
    [[nodiscard]] const Preimage* end() const { return list_.data() + size_; }

    /// Appends a solution of larger t than the last. \pre size() < 3
    void push_back(const Preimage& preimage) { list_[static_cast<std::size_t>(size_++)] = preimage; }

private:
    std::array<Preimage, 3> list_;
    int size_ = 0;
};

/// Inverts the displacement map of one base triangle for any number of points.
///
/// Source: Maggiordomo et al. 2023, "The inverse barycentric displacement problem": the cubic of eqs. 14-16 with the
/// products of section 4 that do not depend on the point computed once. Differences: positions are relative to v_0, and
/// positions and directions are scaled by powers of two, so neither a far origin nor the unit of length costs digits;
/// each coefficient carries a bound on its rounding error, and what hides below its bound counts as zero.
///
/// The answers are rounded, not exact: a sign of alpha or slope near zero is not a proof. Scales from 1e-150 to 1e150
/// are handled as far as the answers are doubles: slopes that are not saturate with their sign kept, solutions whose t
/// or alpha overflows are left out, and the list says that it is not all. A point whose distance overflows in units of
/// the triangle, or that is NaN, has no solution.
class InverseDisplacement {
public:
    /// What of the triangle every inversion uses.
    struct Terms {
        /// Relative error of a coefficient of the cubic against the sum of the sizes of its terms, in roundings on the
        /// longest path: differences of the inputs 2, product of two 1, sum of a cross product 1, sum of two cross
        /// products 1, product with P_0 (one difference) 2, sum of three 2, sum of two dot products 1: 10. Evaluating
        /// the cubic adds 6, and four more cover all terms of higher order.
        static constexpr double coefficient_epsilon = 20.0 * unit_roundoff;

        /// A slice normal above this share of its terms cannot vanish within the uncertainty of a root: that is at most
        /// the cube root of the rounding error, about 1e-5, at a triple root. It saves the exact bound in the common
        /// case.
        static constexpr double surely_no_degenerate_slice = 0x1p-10;

        // The columns of the position and displacement matrices but P_0, scaled (eqs. 11, 12), and the cached products
        // of section 4.
        Vec3 origin;
        Vec3 p1, p2, d0, d1, d2;
        Vec3 t_dd, t_pd, t_pp;
        double a, d0_t_pd, d0_t_pp;
        // Largest components of the columns, bounds on the terms in each component of t_DD, t_PD, t_PP, and the share
        // of D_0 in the errors of the coefficients.
        double size_p1, size_p2, size_d1, size_d2;
        double size_dd, size_pd, size_pp;
        double direction_error;
        // Powers of two: positions and directions are divided by these, and t by the displacement unit.
        double length_unit, direction_unit;
        double inverse_length, displacement_unit, inverse_displacement_unit;
    };

    explicit InverseDisplacement(const BaseTriangle& triangle);

    /// The coefficients of C_q(t) = N(t) . (a_0(t) - q) in scaled units: t in units of displacement_unit(). Nine
    /// products and three exact scalings. (eqs. 15, 16; section 4)
    [[nodiscard]] Cubic cubic(const Vec3& q) const;

    /// The power of two by which a root of cubic() is multiplied to give t.
    [[nodiscard]] double displacement_unit() const { return terms_.displacement_unit; }

    [[nodiscard]] const Terms& terms() const { return terms_; }

    /// All solutions, inside the triangle or not. A double root is listed once. Constant time, no allocation.
    [[nodiscard]] Preimages preimages(const Vec3& q) const;

    /// The solutions with t in `range`; infinitely many only if they are in the range too.
    [[nodiscard]] Preimages preimages(const Vec3& q, const Range& range) const;

    /// The solution inside the triangle of smallest |t|, if there is one among the listed; the smaller t of two that
    /// are equally near. (section 3.2)
    [[nodiscard]] std::optional<Preimage> nearest(const Vec3& q) const;

    /// t |d(alpha)|: the signed distance from the base point to q, which is the displacement along the interpolated
    /// direction once that is renormalised to unit length; model units.
    [[nodiscard]] double renormalised_displacement(const Preimage& preimage) const;

private:
    struct Slice;

    [[nodiscard]] Vec3 relative(const Vec3& q) const;
    [[nodiscard]] Cubic cubic_of(const Vec3& p0) const;
    [[nodiscard]] Cubic error_of(const Vec3& p0) const;
    [[nodiscard]] Slice slice(const Vec3& p0, double t) const;
    [[nodiscard]] Preimage preimage_in(const Slice& slice) const;
    [[nodiscard]] bool vanishes(const Slice& slice, double uncertainty) const;
    [[nodiscard]] bool holds_point(const Slice& slice, double uncertainty) const;
    [[nodiscard]] double to_slope(double scaled) const;

    Terms terms_;
};

} // namespace foldless
