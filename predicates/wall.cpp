#include <foldless/predicates/wall.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// The real roots of c0 + c1 t + c2 t^2, without cancellation; none if it is constant.
struct Roots {
    std::array<double, 2> values;
    int count = 0;
    void add(double root) {
        if (std::isfinite(root)) {
            values[count++] = root;
        }
    }
};

Roots quadratic_roots(double c0, double c1, double c2) {
    Roots roots;
    // A slightly negative discriminant may be a double root: it is tried, and enclose() then refuses it.
    constexpr double nearly_double = 1e-9;
    if (c1 * c1 - 4 * c0 * c2 < -nearly_double * (c1 * c1 + 4 * std::abs(c0 * c2))) {
        return roots;
    }
    const double discriminant = std::max(0.0, c1 * c1 - 4 * c0 * c2);
    const double h = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
    if (h != 0) {
        roots.add(c0 / h);
        roots.add(h / c2);
    } else if (c2 != 0) {
        roots.add(0.0);
    }
    return roots;
}

} // namespace

Wall::Wall(const BaseTriangle& triangle, int opposite)
    : v_i_(triangle.v[(opposite + 1) % 3]), v_j_(triangle.v[(opposite + 2) % 3]), d_i_(triangle.d[(opposite + 1) % 3]),
      d_j_(triangle.d[(opposite + 2) % 3]), r_(v_j_ - v_i_), delta_(d_j_ - d_i_), w0_(r_.cross(d_i_)),
      w1_(r_.cross(delta_)), w2_(delta_.cross(d_i_)), d_i_size_(max_norm(d_i_)), r_size_(max_norm(r_)),
      delta_size_(max_norm(delta_)), size_(r_size_ * (d_i_size_ + delta_size_)), spread_(delta_size_ * d_i_size_) {}

Sign Wall::passes(const Vec3& e, Range range) const {
    const double p0 = e.dot(w0_);
    const double p1 = e.dot(w1_);
    const double p2 = e.dot(w2_);
    // The value is p0 + lambda p1 + t p2, linear in lambda and in t. Each component of a cached product is off by at
    // most 9 roundings of its size (as in ScanNormal), the dot product with e (three more, and the rounding of e
    // itself) and the outer sums by 6 more; 20 covers all with their second-order terms.
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    const double error = 20 * unit_roundoff * sum_norm(e) * (2 * size_ + reach * 2 * spread_);
    const double low_t = std::min(range.lo * p2, range.hi * p2);
    const double high_t = std::max(range.lo * p2, range.hi * p2);
    const double low = p0 + std::min(0.0, p1) + low_t;
    const double high = p0 + std::max(0.0, p1) + high_t;
    if (low > error) {
        return Sign::positive;
    }
    return high < -error ? Sign::negative : Sign::undecided;
}

Sign Wall::passes_at(const Vec3& e, const Crossing& at) const {
    const double value = e.dot(w0_) + at.lambda * e.dot(w1_) + at.t * e.dot(w2_);
    const double error = 20 * unit_roundoff * sum_norm(e) * (2 * size_ + std::abs(at.t) * 2 * spread_) +
                         2 * at.error * std::abs(e.dot(w1_)) + 2 * at.t_error * std::abs(e.dot(w2_));
    return sign_within(value, error);
}

Sign Wall::passes_at_corner(const Vec3& e, int lambda) const {
    const double value = e.dot(w0_) + lambda * e.dot(w1_);
    return sign_within(value, 40 * unit_roundoff * sum_norm(e) * size_); // the bound of passes() at t = 0
}

/// side(t) = c0 + c1 t + c2 t^2.
struct Wall::Side {
    double c0, c1, c2;
};

Wall::Side Wall::side(const Vec3& a, const Vec3& e) const {
    // e.((x + t d_i) x (r + t delta)) with x = v_i - a.
    const Vec3 m = e.cross(v_i_ - a);
    return {m.dot(r_), m.dot(delta_) - e.dot(w0_), -e.dot(w2_)};
}

// As in passes(): each of the two bounds below is 20 roundings of the sizes of the factors, for each of the few terms.

bool Wall::misses(const Vec3& a, const Vec3& e, Range range) const {
    const Side s = side(a, e);
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    const double error = 20 * unit_roundoff * sum_norm(e) * 2 * (max_norm(v_i_ - a) + reach * d_i_size_) *
                         (r_size_ + reach * delta_size_);
    const double b0 = s.c0 + range.lo * (s.c1 + range.lo * s.c2);
    const double b2 = s.c0 + range.hi * (s.c1 + range.hi * s.c2);
    const double b1 = s.c0 + 0.5 * (range.lo + range.hi) * s.c1 + range.lo * range.hi * s.c2;
    return std::min({b0, b1, b2}) > error || std::max({b0, b1, b2}) < -error;
}

bool Wall::meets_once_at_most(const Vec3& a, const Vec3& e, Range range) const {
    const Side s = side(a, e);
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    const double error =
        20 * unit_roundoff * sum_norm(e) * 4 *
        (d_i_size_ * (r_size_ + reach * delta_size_) + (max_norm(v_i_ - a) + reach * d_i_size_) * delta_size_);
    const double at_lo = s.c1 + 2 * range.lo * s.c2;
    const double at_hi = s.c1 + 2 * range.hi * s.c2;
    return std::min(at_lo, at_hi) > error || std::max(at_lo, at_hi) < -error;
}

bool Wall::met_only_at_corner(const Vec3& e, int lambda, Range range) const {
    // With q = v_i: a_i - q = t d_i and a_j - q = r + t d_j; with q = v_j: -r + t d_i and t d_j.
    const double linear = lambda == 0 ? -e.dot(w0_) : -e.dot(r_.cross(d_j_));
    const double quadratic = -e.dot(w2_); // d_i x d_j = d_i x delta
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    // As in passes(): at most 20 roundings of the sizes of the factors.
    const double d_size = d_i_size_ + max_norm(d_j_);
    const double error = 20 * unit_roundoff * sum_norm(e) * 2 * d_size * (r_size_ + reach * d_size);
    const double at_lo = linear + range.lo * quadratic;
    const double at_hi = linear + range.hi * quadratic;
    return std::min(at_lo, at_hi) > error || std::max(at_lo, at_hi) < -error;
}

Wall::Crossings Wall::crossings(const Vec3& a, const Vec3& e, const Wanted& wanted) const {
    // side(t) vanishes where the line meets the line of the slice of the wall.
    const Side polynomial = side(a, e);
    const Roots roots = quadratic_roots(polynomial.c0, polynomial.c1, polynomial.c2);
    Crossings result;
    for (int k = 0; k < roots.count; ++k) {
        const std::optional<Crossing> crossing = crossing_at(a, e, roots.values[k], wanted);
        if (crossing) {
            result.values[result.count++] = *crossing;
        }
    }
    return result;
}

std::optional<Wall::Crossing> Wall::crossing_at(const Vec3& a, const Vec3& e, double t, const Wanted& wanted) const {
    // A root in plain doubles is off by less than this share of the wall, of the edge and of the range, even if it is
    // nearly double (the square root of the rounding, 1e-8): what lies further out is out.
    constexpr double slack = 1e-4;
    const auto outside = [](double value, double lo, double hi, double margin) {
        return value < lo - margin || value > hi + margin;
    };
    const double t_unit = r_size_ / (d_i_size_ + delta_size_); // as far as the wall is wide
    if (outside(t, wanted.range.lo, wanted.range.hi, slack * (std::abs(t) + t_unit))) {
        return std::nullopt;
    }
    // In the slice: a + s e = a_i + lambda (a_j - a_i), solved in the projection in which it is best determined.
    const Vec3 r = r_ + t * delta_;
    const Vec3 start = (v_i_ - a) + t * d_i_;
    const Vec3 n = r.cross(e);
    int axis = 0;
    n.cwiseAbs().maxCoeff(&axis);
    const auto area = [x = (axis + 1) % 3, y = (axis + 2) % 3](const Vec3& u, const Vec3& v) {
        return u[x] * v[y] - u[y] * v[x];
    };
    const double s = -area(start, r) / n[axis];
    const double lambda = -area(start, e) / n[axis];
    if (n[axis] == 0 || outside(s, 0, 1, slack) || outside(lambda, 0, 1, slack)) {
        return std::nullopt;
    }
    if (wanted.outwards_only && passes_at(e, {s, lambda, t, slack, slack * std::abs(t)}) == Sign::negative) {
        return std::nullopt;
    }
    const BaseTriangle system{{v_i_, v_j_, v_i_ - e}, {d_i_, d_j_, d_i_}};
    const std::optional<Enclosure> known = enclose(system, a, Vec3(1 - s - lambda, lambda, s), t);
    if (!known) {
        const double infinity = std::numeric_limits<double>::infinity();
        return Crossing{s, lambda, t, infinity, infinity};
    }
    const Crossing crossing{known->alpha[2], known->alpha[1], known->t, known->alpha_error, known->t_error};
    const bool in_unit = !outside(crossing.s, 0, 1, crossing.error) && !outside(crossing.lambda, 0, 1, crossing.error);
    return in_unit ? std::optional<Crossing>(crossing) : std::nullopt;
}

EdgePart part_of_edge(const Vec3& a, const Vec3& e, const std::array<double, 2>& s, double s_error) {
    // One rounding in e, one in the product, one in the sum.
    const double rounding = 3 * unit_roundoff * (max_norm(a) + max_norm(e));
    return {a + s[0] * e, a + s[1] * e, rounding + s_error * max_norm(e)};
}

bool stays_off_wall(const BaseTriangle& triangle, int opposite, const EdgePart& part, Range range) {
    const int i = (opposite + 1) % 3;
    const int j = (opposite + 2) % 3;
    const Vec3 c = triangle.d[0] + triangle.d[1] + triangle.d[2];
    const double c_size = sum_norm(triangle.d[0]) + sum_norm(triangle.d[1]) + sum_norm(triangle.d[2]);
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    bool above = true;
    bool below = true;
    for (const Vec3& q : {part.from, part.to}) {
        // Bernstein coefficients in t of c.((a_i - q) x (a_j - q)), which is linear along the edge.
        const Vec3 i_lo = (triangle.v[i] - q) + range.lo * triangle.d[i];
        const Vec3 i_hi = (triangle.v[i] - q) + range.hi * triangle.d[i];
        const Vec3 j_lo = (triangle.v[j] - q) + range.lo * triangle.d[j];
        const Vec3 j_hi = (triangle.v[j] - q) + range.hi * triangle.d[j];
        const double size_i = max_norm(triangle.v[i] - q) + reach * max_norm(triangle.d[i]);
        const double size_j = max_norm(triangle.v[j] - q) + reach * max_norm(triangle.d[j]);
        // Three roundings in each difference, four in the cross product, three in the dot product, two in c: 30 covers
        // them on the three components of twice the product of the sizes. Moving q by the error of the part moves the
        // cross product by twice the sizes, and the second order.
        const double rounding = 30 * unit_roundoff * 2 * size_i * size_j;
        const double moved = 2 * part.error * (size_i + size_j + part.error);
        const double error = c_size * (rounding + moved);
        const double b0 = c.dot(i_lo.cross(j_lo));
        const double b2 = c.dot(i_hi.cross(j_hi));
        const double b1 = 0.5 * c.dot(i_lo.cross(j_hi) + i_hi.cross(j_lo));
        above = above && std::min({b0, b1, b2}) > error;
        below = below && std::max({b0, b1, b2}) < -error;
    }
    return above || below;
}

} // namespace foldless
