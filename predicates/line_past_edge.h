/// \file
/// On which side of an edge of the scan the line along a displacement direction passes.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

namespace foldless {

/// The line x + t d through a point of a base triangle along its interpolated direction, as a sample of a map has it:
/// the point is given exactly by barycentric weights, x and d are rounded.
class SampleLine {
public:
    /// \param weights integers in the ratio of the barycentric coordinates, none so large that their sum is not a
    /// double; a sample outside the triangle has negative ones. Their sum is positive. Refers to the triangle.
    SampleLine(const BaseTriangle& triangle, const Vec3& weights);

    [[nodiscard]] const Vec3& point() const { return x_; }
    [[nodiscard]] const Vec3& direction() const { return d_; }

    /// The determinant det(a - x, b - x, d), and whether its sign is certain: positive where the line passes to the
    /// left of the edge from a to b, seen from in front of a triangle that has it on its left. Of a scan triangle the
    /// three have the sum d.n, and the ratio of the barycentric coordinates of the corners opposite.
    /// Its sign is exact: zero only if the line meets the line through a and b or is parallel to it.
    struct Side {
        Sign sign;
        double value; ///< rounded, of this sign
    };
    /// Constant time; exact arithmetic only where rounding could hide the sign.
    [[nodiscard]] Side side(const Vec3& a, const Vec3& b) const;

private:
    [[nodiscard]] Sign exact_side(const Vec3& a, const Vec3& b) const;

    const BaseTriangle* triangle_;
    Vec3 weights_;
    Vec3 x_, d_;
    double x_error_; ///< of a component of x
    double d_error_; ///< of a component of d
};

} // namespace foldless
