#include <foldless/io/zero_area.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <limits>

namespace foldless {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// The determinant of a projected triangle is wrong by at most (3 + 16 u) u times the sum of its two products, where
// u = 2^-53 (Shewchuk 1997, section 4.3, ccwerrboundA); epsilon is 2 u.
constexpr double relative_error = 2 * std::numeric_limits<double>::epsilon();

// That bound counts no underflow, which adds less than the smallest normal number. Beside a sum of products above this,
// it is less than what the bound above leaves to spare: u times the sum.
constexpr double least_product = std::numeric_limits<double>::min() / (relative_error * relative_error);

/// True only if the projection of the triangle to the axes x and y has an area; NaN and overflow say false.
bool certainly_has_area(const ScanTriangle& t, int x, int y) {
    const double left = (t[0][x] - t[2][x]) * (t[1][y] - t[2][y]);
    const double right = (t[0][y] - t[2][y]) * (t[1][x] - t[2][x]);
    const double sum = std::abs(left) + std::abs(right);
    return sum > least_product && std::abs(left - right) > relative_error * sum;
}

Kernel::Point_3 point(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

} // namespace

bool has_zero_area(const ScanTriangle& triangle) {
    if (certainly_has_area(triangle, 0, 1) || certainly_has_area(triangle, 1, 2) ||
        certainly_has_area(triangle, 2, 0)) {
        return false;
    }
    return CGAL::collinear(point(triangle[0]), point(triangle[1]), point(triangle[2]));
}

} // namespace foldless
