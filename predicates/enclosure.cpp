#include <foldless/predicates/enclosure.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// F(x1, x2, t) = p0 + x1 (p1 + t d1) + x2 (p2 + t d2) + t d0, the displacement of a point of the triangle minus q.
struct System {
    Vec3 p0, p1, p2;
    Vec3 d0, d1, d2;

    System(const BaseTriangle& triangle, const Vec3& q)
        : p0(triangle.v[0] - q), p1(triangle.v[1] - triangle.v[0]), p2(triangle.v[2] - triangle.v[0]),
          d0(triangle.d[0]), d1(triangle.d[1] - triangle.d[0]), d2(triangle.d[2] - triangle.d[0]) {}
};

struct Unknowns {
    double x1, x2, t;
};

/// F and the rows of an approximate inverse of its derivative [e1 | e2 | d].
struct Linearisation {
    Vec3 residual;
    Vec3 row1, row2, row_t;
    double determinant;

    Linearisation(const System& s, const Unknowns& x) {
        const Vec3 e1 = s.p1 + x.t * s.d1;
        const Vec3 e2 = s.p2 + x.t * s.d2;
        const Vec3 d = s.d0 + x.x1 * s.d1 + x.x2 * s.d2;
        residual = s.p0 + x.t * s.d0 + x.x1 * e1 + x.x2 * e2;
        const Vec3 normal = e1.cross(e2);
        determinant = normal.dot(d);
        const double inverse = 1 / determinant;
        row1 = inverse * e2.cross(d);
        row2 = inverse * d.cross(e1);
        row_t = inverse * normal;
    }
};

/// Radii around a point of the unknowns within which there is a root.
struct Ball {
    double alpha;
    double t;
};

/// The ball that the simplified Newton map around x sends into itself, if there is one.
std::optional<Ball> ball_around(const System& s, const Unknowns& x, const Linearisation& at) {
    // Sizes, in the maximum norm: e bounds e1 and e2, d bounds d(alpha), with every term taken positively so that
    // cancellation cannot hide rounding; spread bounds d1 and d2.
    const double weight = 1 + std::abs(x.x1) + std::abs(x.x2);
    const double spread = std::max(max_norm(s.d1), max_norm(s.d2));
    const double e = std::max(max_norm(s.p1), max_norm(s.p2)) + std::abs(x.t) * spread;
    const double d = max_norm(s.d0) + weight * spread;

    // Rounding of the residual. Each of its terms carries at most 8 roundings: a difference of coordinates, the
    // product with t, the inner sum, the product with x, and four outer sums. 10 covers the second-order terms.
    const double residual_error =
        10 * unit_roundoff * (max_norm(s.p0) + std::abs(x.t) * max_norm(s.d0) + 2 * weight * e);
    const double residual = max_norm(at.residual) + residual_error;

    // In the norm max(|h1|, |h2|, |h_t| d/e), the simplified Newton map is K(h) = -C F + (I - C DF) h - C h_t (h1 d1 +
    // h2 d2) with C the rows above.
    const double scale = d / e;
    const double inverse = std::max({sum_norm(at.row1), sum_norm(at.row2), sum_norm(at.row_t) * scale});
    const double first = 1.01 * inverse * residual;
    // Each entry of C DF is a 3-term sum of products of three factors, off by at most 60 roundings of the product of
    // the sizes of its factors: 24 from the cross product, 12 from each factor (4 roundings in e, 6 in d), 4 from the
    // dot product and the reciprocal. In the scaled norm all nine entries have the same bound.
    const double defect = 60 * unit_roundoff * e * e * d / std::abs(at.determinant);
    const double second = 1.01 * inverse * 2 * spread / scale;

    // With R = 2 first: first + 3 defect R + second R^2 <= R/2 + R/4 + R/4.
    const bool contracts = 12 * defect <= 1 && 8 * second * first <= 1;
    if (!contracts || !std::isfinite(first) || !at.residual.allFinite()) { // the maximum norm may overlook a NaN
        return std::nullopt;
    }
    const double radius = 2 * first;
    return Ball{2 * radius + 2 * unit_roundoff * weight, radius / scale};
}

/// A guess with barycentric coordinates known this well is good enough to decide almost every sign; a worse one is
/// polished.
constexpr double good_enough = 1e-11;

} // namespace

std::optional<Enclosure> enclose(const BaseTriangle& triangle, const Vec3& q, const Vec3& alpha, double t) {
    const System s(triangle, q);
    Unknowns x{alpha[1], alpha[2], t};
    const Linearisation guess(s, x);
    std::optional<Ball> ball = ball_around(s, x, guess);
    if (!ball || ball->alpha > good_enough) {
        x.x1 -= guess.row1.dot(guess.residual);
        x.x2 -= guess.row2.dot(guess.residual);
        x.t -= guess.row_t.dot(guess.residual);
        ball = ball_around(s, x, Linearisation(s, x));
    }
    if (!ball) {
        return std::nullopt;
    }
    return Enclosure{Vec3(1 - x.x1 - x.x2, x.x1, x.x2), x.t, ball->alpha, ball->t};
}

} // namespace foldless
