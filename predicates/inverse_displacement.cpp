#include <foldless/predicates/inverse_displacement.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// Relative error of a component of a slice's corner difference, a product of two of them, and their difference.
constexpr double slice_epsilon = 8.0 * unit_roundoff;

/// The scales are at most 2^500 (3e150) either way, so that their quotients and squares are normal doubles. Inputs
/// beyond that are scaled by as much as that, and may overflow.
constexpr int largest_exponent = 500;

/// The exponent of the power of two just above every component, or no value if all are zero or one is not finite.
std::optional<int> exponent_of(std::initializer_list<Vec3> vectors) {
    double largest = 0.0;
    for (const Vec3& vector : vectors) {
        largest = std::max(largest, vector.lpNorm<Eigen::Infinity>());
    }
    if (largest == 0.0 || !std::isfinite(largest)) {
        return std::nullopt;
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    return std::clamp(exponent, -largest_exponent, largest_exponent);
}

/// The sum in this order, which kernels follow.
double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The sum in this order, too.
double sum_of_sizes(const Vec3& vector) {
    return std::abs(vector[0]) + std::abs(vector[1]) + std::abs(vector[2]);
}

double size(const Vec3& vector) {
    return std::max(std::max(std::abs(vector[0]), std::abs(vector[1])), std::abs(vector[2]));
}

} // namespace

/// The triangle a_0, a_1, a_2 at one t, seen from a_0 and in scaled units.
struct InverseDisplacement::Slice {
    double t;
    Vec3 edge1;          // a_1 - a_0
    Vec3 edge2;          // a_2 - a_0
    Vec3 point;          // q - a_0
    Vec3 normal;         // N(t)
    double size1, size2; // bounds on the terms that edge1 and edge2 are the sums of
};

InverseDisplacement::InverseDisplacement(const BaseTriangle& triangle) {
    terms_.origin = triangle.v[0];
    const Vec3 p1 = triangle.v[1] - triangle.v[0];
    const Vec3 p2 = triangle.v[2] - triangle.v[0];
    const auto length = exponent_of({p1, p2});
    const auto direction = exponent_of({triangle.d[0], triangle.d[1], triangle.d[2]});
    const int length_exponent = length.value_or(direction.value_or(0));
    terms_.length_unit = std::ldexp(1.0, length_exponent);
    terms_.direction_unit = std::ldexp(1.0, direction.value_or(length_exponent));
    terms_.inverse_length = 1.0 / terms_.length_unit;
    terms_.displacement_unit = terms_.length_unit / terms_.direction_unit;
    terms_.inverse_displacement_unit = terms_.direction_unit / terms_.length_unit;
    const double inverse_direction = 1.0 / terms_.direction_unit;
    terms_.p1 = p1 * terms_.inverse_length;
    terms_.p2 = p2 * terms_.inverse_length;
    terms_.d0 = triangle.d[0] * inverse_direction;
    terms_.d1 = triangle.d[1] * inverse_direction - terms_.d0;
    terms_.d2 = triangle.d[2] * inverse_direction - terms_.d0;
    terms_.t_dd = terms_.d1.cross(terms_.d2);
    terms_.t_pd = terms_.p1.cross(terms_.d2) + terms_.d1.cross(terms_.p2);
    terms_.t_pp = terms_.p1.cross(terms_.p2);
    terms_.a = terms_.d0.dot(terms_.t_dd);
    terms_.d0_t_pd = terms_.d0.dot(terms_.t_pd);
    terms_.d0_t_pp = terms_.d0.dot(terms_.t_pp);
    terms_.size_p1 = size(terms_.p1);
    terms_.size_p2 = size(terms_.p2);
    terms_.size_d1 = size(terms_.d1);
    terms_.size_d2 = size(terms_.d2);
    terms_.size_dd = 2.0 * terms_.size_d1 * terms_.size_d2;
    terms_.size_pd = 2.0 * (terms_.size_p1 * terms_.size_d2 + terms_.size_d1 * terms_.size_p2);
    terms_.size_pp = 2.0 * terms_.size_p1 * terms_.size_p2;
    terms_.direction_error = Terms::coefficient_epsilon * terms_.d0.lpNorm<1>();
}

Vec3 InverseDisplacement::relative(const Vec3& q) const {
    return (terms_.origin - q) * terms_.inverse_length;
}

Cubic InverseDisplacement::cubic(const Vec3& q) const {
    return cubic_of(relative(q));
}

Cubic InverseDisplacement::cubic_of(const Vec3& p0) const {
    return {terms_.a, dot(p0, terms_.t_dd) + terms_.d0_t_pd, dot(p0, terms_.t_pd) + terms_.d0_t_pp,
            dot(p0, terms_.t_pp)};
}

Cubic InverseDisplacement::error_of(const Vec3& p0) const {
    const double p = Terms::coefficient_epsilon * sum_of_sizes(p0);
    const double d = terms_.direction_error;
    return {d * terms_.size_dd, p * terms_.size_dd + d * terms_.size_pd, p * terms_.size_pd + d * terms_.size_pp,
            p * terms_.size_pp};
}

InverseDisplacement::Slice InverseDisplacement::slice(const Vec3& p0, double t) const {
    Slice slice;
    slice.t = t;
    slice.edge1 = terms_.p1 + t * terms_.d1;
    slice.edge2 = terms_.p2 + t * terms_.d2;
    slice.point = -(p0 + t * terms_.d0);
    slice.normal = slice.edge1.cross(slice.edge2);
    slice.size1 = terms_.size_p1 + std::abs(t) * terms_.size_d1;
    slice.size2 = terms_.size_p2 + std::abs(t) * terms_.size_d2;
    return slice;
}

// Ratios of areas in the slice, as eq. 17, but projected along the axis nearest to the normal: the point lies in the
// plane of the slice, so any projection gives the same ratios, and this one costs two products an area and at most a
// factor sqrt(3) in rounding.
Preimage InverseDisplacement::preimage_in(const Slice& slice) const {
    int axis = 0;
    slice.normal.cwiseAbs().maxCoeff(&axis);
    const int x = (axis + 1) % 3;
    const int y = (axis + 2) % 3;
    const auto area = [x, y](const Vec3& a, const Vec3& b) { return a[x] * b[y] - a[y] * b[x]; };
    const double alpha1 = area(slice.point, slice.edge2) / slice.normal[axis];
    const double alpha2 = area(slice.edge1, slice.point) / slice.normal[axis];
    const double slope = dot(slice.normal, terms_.d0 + alpha1 * terms_.d1 + alpha2 * terms_.d2);
    return {Vec3(1.0 - alpha1 - alpha2, alpha1, alpha2), slice.t * terms_.displacement_unit, to_slope(slope)};
}

// N(t) has two factors of length and J one more of direction; in this order no product overflows or underflows unless
// the slope does.
double InverseDisplacement::to_slope(double scaled) const {
    const double slope = scaled * terms_.length_unit * terms_.direction_unit * terms_.length_unit;
    return slope == 0.0 && scaled != 0.0 ? std::copysign(std::numeric_limits<double>::denorm_min(), scaled) : slope;
}

// Whether N is zero at some t within the uncertainty: |N(t + r) - N(t)| <= |N'(t)| |r| + |t_DD| r^2.
bool InverseDisplacement::vanishes(const Slice& slice, double uncertainty) const {
    const Vec3 change = terms_.t_pd + 2.0 * slice.t * terms_.t_dd;
    const double rounding = slice_epsilon * 2.0 * slice.size1 * slice.size2;
    return size(slice.normal) <= (size(change) + uncertainty * size(terms_.t_dd)) * uncertainty + rounding;
}

// Whether q is on the line, or the point, to which a slice has shrunk: it is if it is within `slack` of one of its
// edges or of all of its corners, where `slack` bounds how far corners move within the uncertainty.
bool InverseDisplacement::holds_point(const Slice& slice, double uncertainty) const {
    const double speed = size(terms_.d0) + std::max(terms_.size_d1, terms_.size_d2);
    const double terms = size(slice.point) + std::abs(slice.t) * size(terms_.d0) + std::max(slice.size1, slice.size2);
    const double slack = 2.0 * (speed * uncertainty + slice_epsilon * terms);
    const Vec3& edge = size(slice.edge1) >= size(slice.edge2) ? slice.edge1 : slice.edge2;
    if (size(edge) <= slack) {
        return size(slice.point) <= slack;
    }
    // Moving the end of the edge by slack moves the line at q by as much times its distance in edges.
    const double reach = 1.0 + size(slice.point) / size(edge);
    return size(slice.point.cross(edge)) <= 2.0 * slack * reach * size(edge);
}

namespace {

/// How far from a computed root t the polynomial may still be zero. By Taylor the distance r obeys
/// |C'| r <= error, or |C''| r^2 / 2 <= error, or |a| r^3 <= error if the other terms have the same sign; the least of
/// the three that is large enough is at most twice their minimum.
double root_uncertainty(const Cubic& cubic, double t, double error) {
    if (error == 0.0) {
        return 0.0;
    }
    const double second = std::abs(3.0 * cubic.a * t + cubic.b);
    return 2.0 * std::min({error / std::abs(cubic.slope(t)), std::sqrt(error / second),
                           std::cbrt(error / std::abs(cubic.a)), std::numeric_limits<double>::max()});
}

} // namespace

namespace {

/// The roots in the range, and perhaps others.
RealRoots roots_near(const Cubic& cubic, const Cubic& error, const Range& range) {
    if (std::isfinite(range.lo) && std::isfinite(range.hi)) {
        if (const std::optional<RealRoots> only = rising_root(cubic, error, range.lo, range.hi)) {
            return *only;
        }
    }
    return real_roots(cubic, error);
}

} // namespace

Preimages InverseDisplacement::preimages(const Vec3& q) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return preimages(q, {-infinity, infinity});
}

Preimages InverseDisplacement::preimages(const Vec3& q, const Range& range) const {
    const Vec3 p0 = relative(q);
    const Cubic cubic = cubic_of(p0);
    const Cubic error = error_of(p0);
    const RealRoots roots =
        roots_near(cubic, error, {range.lo / terms_.displacement_unit, range.hi / terms_.displacement_unit});
    Preimages result;
    bool is_incomplete = roots.everywhere;
    for (const double t : roots) {
        const double model_t = t * terms_.displacement_unit;
        if (!(range.lo <= model_t && model_t <= range.hi)) {
            continue;
        }
        const Slice at = slice(p0, t);
        const bool small = size(at.normal) <= Terms::surely_no_degenerate_slice * at.size1 * at.size2;
        const double uncertainty = small ? root_uncertainty(cubic, t, error_at(error, t)) : 0.0;
        if (!small || !vanishes(at, uncertainty)) {
            const Preimage preimage = preimage_in(at);
            if (std::isfinite(preimage.t) && preimage.alpha.allFinite()) {
                result.push_back(preimage);
            } else {
                is_incomplete = true;
            }
        } else if (holds_point(at, uncertainty)) {
            is_incomplete = true;
        }
    }
    result.kind = is_incomplete    ? Preimages::Kind::infinite
                  : result.empty() ? Preimages::Kind::none
                                   : Preimages::Kind::finite;
    return result;
}

std::optional<Preimage> InverseDisplacement::nearest(const Vec3& q) const {
    std::optional<Preimage> best;
    for (const Preimage& preimage : preimages(q)) {
        if (inside(preimage) && (!best || std::abs(preimage.t) < std::abs(best->t))) {
            best = preimage;
        }
    }
    return best;
}

double InverseDisplacement::renormalised_displacement(const Preimage& preimage) const {
    const Vec3 direction = terms_.d0 + preimage.alpha[1] * terms_.d1 + preimage.alpha[2] * terms_.d2;
    return preimage.t * (direction.norm() * terms_.direction_unit);
}

} // namespace foldless
