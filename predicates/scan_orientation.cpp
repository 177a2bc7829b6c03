#include <foldless/predicates/scan_orientation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2.0;

/// What rounding may add to the determinant of four rounded differences, against |x1 y2| + |x2 y1|: each product
/// carries two rounded differences and its own rounding (3), their difference one more (4); the bound itself is
/// computed with six roundings of relative size u in terms of this size, and second-order terms are far below the last
/// one (12).
constexpr double determinant_epsilon = 12.0 * unit_roundoff;

/// The bound is a sum of products of non-negative numbers, so it is short by at most a few of its own roundings.
constexpr double bound_growth = 1.0 + 8.0 * unit_roundoff;

/// The two products and the bound may each lose this much to underflow; eight of it is more than all of them.
constexpr double underflow = 8.0 * std::numeric_limits<double>::denorm_min();

CGAL::Point_2<Kernel> point(const Vec3& alpha) {
    return {alpha[0], alpha[1]};
}

bool exact(const std::array<double, 3>& error) {
    return std::all_of(error.begin(), error.end(), [](double e) { return e == 0.0; });
}

} // namespace

Sign scan_orientation(const BarycentricTriangle& alpha) {
    if (!std::all_of(alpha.begin(), alpha.end(), [](const Vec3& a) { return a.head<2>().allFinite(); })) {
        return Sign::undecided;
    }
    switch (CGAL::orientation(point(alpha[0]), point(alpha[1]), point(alpha[2]))) {
    case CGAL::LEFT_TURN: return Sign::positive;
    case CGAL::RIGHT_TURN: return Sign::negative;
    default: return Sign::zero;
    }
}

// With differences x + dx, y + dy the determinant moves by x1 dy2 + y2 dx1 + dx1 dy2 - ..., where |dx1|, |dy1| <= e1,
// the sum of the errors of corners 0 and 1, and |dx2|, |dy2| <= e2 likewise.
Sign scan_orientation(const BarycentricTriangle& alpha, const std::array<double, 3>& error) {
    if (exact(error)) {
        return scan_orientation(alpha);
    }
    const double x1 = alpha[1][0] - alpha[0][0];
    const double y1 = alpha[1][1] - alpha[0][1];
    const double x2 = alpha[2][0] - alpha[0][0];
    const double y2 = alpha[2][1] - alpha[0][1];
    const double e1 = error[0] + error[1];
    const double e2 = error[0] + error[2];
    const double size1 = std::abs(x1) + std::abs(y1);
    const double size2 = std::abs(x2) + std::abs(y2);
    const double moved = size1 * e2 + size2 * e1 + 2.0 * e1 * e2;
    const double rounded = determinant_epsilon * (std::abs(x1 * y2) + std::abs(x2 * y1));
    return sign_within(x1 * y2 - x2 * y1, (moved + rounded) * bound_growth + underflow);
}

} // namespace foldless
