#include <foldless/predicates/scan_orientation.h>

#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/real_root.h>
#include <foldless/predicates/rounding.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace foldless {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

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

/// All numbers between two exact ones.
struct ExactInterval {
    Exact lo;
    Exact hi;
};

ExactInterval operator+(const ExactInterval& a, const ExactInterval& b) {
    return {a.lo + b.lo, a.hi + b.hi};
}
ExactInterval operator-(const ExactInterval& a, const ExactInterval& b) {
    return {a.lo - b.hi, a.hi - b.lo};
}
ExactInterval operator*(const ExactInterval& a, const ExactInterval& b) {
    ExactInterval result{a.lo * b.lo, a.lo * b.lo};
    for (const Exact& x : {a.lo * b.hi, a.hi * b.lo, a.hi * b.hi}) {
        result.lo = sign_of(x - result.lo) == Sign::negative ? x : result.lo;
        result.hi = sign_of(x - result.hi) == Sign::positive ? x : result.hi;
    }
    return result;
}
Sign common_sign(const ExactInterval& x) {
    const Sign lo = sign_of(x.lo);
    const Sign hi = sign_of(x.hi);
    return lo == hi ? lo : Sign::undecided;
}

/// One point: alpha times a positive number, at a root.
class Row {
public:
    Row(const BaseTriangle& triangle, const DisplacedPoint& point) : root_(point.t.exact()) {
        for (int k = 0; k < 3; ++k) {
            sides_[k] = side<Exact>(triangle, k, point.q, exactly<Exact>(triangle.d[0]));
        }
    }

    void halve(int times) {
        for (int n = 0; n < times; ++n) {
            root_.refine();
        }
    }
    [[nodiscard]] std::array<ExactInterval, 3> values() const {
        const ExactInterval t{root_.lo(), root_.hi()};
        std::array<ExactInterval, 3> result;
        for (int k = 0; k < 3; ++k) {
            const auto& [c0, c1, c2] = sides_[k];
            result[k] = (ExactInterval{c2, c2} * t + ExactInterval{c1, c1}) * t + ExactInterval{c0, c0};
        }
        return result;
    }

private:
    RealRoot root_;
    std::array<Coefficients<Exact, 3>, 3> sides_;
};

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

Sign scan_orientation(const BaseTriangle& triangle, const std::array<DisplacedPoint, 3>& points) {
    count_exact();
    std::array<Row, 3> rows{Row(triangle, points[0]), Row(triangle, points[1]), Row(triangle, points[2])};
    constexpr int rounds = 4;
    constexpr int halvings = 64;
    for (int round = 0; round <= rounds; ++round) {
        const std::array<ExactInterval, 3> a = rows[0].values();
        const std::array<ExactInterval, 3> b = rows[1].values();
        const std::array<ExactInterval, 3> c = rows[2].values();
        // Each row is alpha times a positive number, and the determinant of three alpha is the orientation.
        const Sign sign = common_sign(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                                      a[2] * (b[0] * c[1] - b[1] * c[0]));
        if (sign != Sign::undecided) {
            return sign;
        }
        for (Row& row : rows) {
            row.halve(halvings);
        }
    }
    return Sign::undecided;
}

} // namespace foldless
