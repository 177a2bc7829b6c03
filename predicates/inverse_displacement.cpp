#include <foldless/predicates/inverse_displacement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2.0;

/// Relative error of a coefficient of the cubic against the sum of the sizes of its terms, in roundings on the longest
/// path: differences of the inputs 2, product of two 1, sum of a cross product 1, sum of two cross products 1, product
/// with P_0 (one difference) 2, sum of three 2, sum of two dot products 1: 10. Evaluating the cubic adds 6, and four
/// more cover all terms of higher order.
constexpr double coefficient_epsilon = 20.0 * unit_roundoff;

/// Relative error of a component of a slice's corner difference, a product of two of them, and their difference.
constexpr double slice_epsilon = 8.0 * unit_roundoff;

/// A slice normal above this share of its terms cannot vanish within the uncertainty of a root: that is at most the
/// cube root of the rounding error, about 1e-5, at a triple root. It saves the exact bound in the common case.
constexpr double surely_no_degenerate_slice = 0x1p-10;

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

InverseDisplacement::InverseDisplacement(const BaseTriangle& triangle) : origin_(triangle.v[0]) {
    const Vec3 p1 = triangle.v[1] - triangle.v[0];
    const Vec3 p2 = triangle.v[2] - triangle.v[0];
    const auto length = exponent_of({p1, p2});
    const auto direction = exponent_of({triangle.d[0], triangle.d[1], triangle.d[2]});
    const int length_exponent = length.value_or(direction.value_or(0));
    length_unit_ = std::ldexp(1.0, length_exponent);
    direction_unit_ = std::ldexp(1.0, direction.value_or(length_exponent));
    inverse_length_ = 1.0 / length_unit_;
    displacement_unit_ = length_unit_ / direction_unit_;
    const double inverse_direction = 1.0 / direction_unit_;
    p1_ = p1 * inverse_length_;
    p2_ = p2 * inverse_length_;
    d0_ = triangle.d[0] * inverse_direction;
    d1_ = triangle.d[1] * inverse_direction - d0_;
    d2_ = triangle.d[2] * inverse_direction - d0_;
    t_dd_ = d1_.cross(d2_);
    t_pd_ = p1_.cross(d2_) + d1_.cross(p2_);
    t_pp_ = p1_.cross(p2_);
    a_ = d0_.dot(t_dd_);
    d0_t_pd_ = d0_.dot(t_pd_);
    d0_t_pp_ = d0_.dot(t_pp_);
    size_p1_ = size(p1_);
    size_p2_ = size(p2_);
    size_d1_ = size(d1_);
    size_d2_ = size(d2_);
    size_dd_ = 2.0 * size_d1_ * size_d2_;
    size_pd_ = 2.0 * (size_p1_ * size_d2_ + size_d1_ * size_p2_);
    size_pp_ = 2.0 * size_p1_ * size_p2_;
    direction_error_ = coefficient_epsilon * d0_.lpNorm<1>();
}

Vec3 InverseDisplacement::relative(const Vec3& q) const {
    return (origin_ - q) * inverse_length_;
}

Cubic InverseDisplacement::cubic(const Vec3& q) const {
    return cubic_of(relative(q));
}

Cubic InverseDisplacement::cubic_of(const Vec3& p0) const {
    return {a_, p0.dot(t_dd_) + d0_t_pd_, p0.dot(t_pd_) + d0_t_pp_, p0.dot(t_pp_)};
}

Cubic InverseDisplacement::error_of(const Vec3& p0) const {
    const double p = coefficient_epsilon * p0.lpNorm<1>();
    const double d = direction_error_;
    return {d * size_dd_, p * size_dd_ + d * size_pd_, p * size_pd_ + d * size_pp_, p * size_pp_};
}

InverseDisplacement::Slice InverseDisplacement::slice(const Vec3& p0, double t) const {
    Slice slice;
    slice.t = t;
    slice.edge1 = p1_ + t * d1_;
    slice.edge2 = p2_ + t * d2_;
    slice.point = -(p0 + t * d0_);
    slice.normal = slice.edge1.cross(slice.edge2);
    slice.size1 = size_p1_ + std::abs(t) * size_d1_;
    slice.size2 = size_p2_ + std::abs(t) * size_d2_;
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
    const double slope = slice.normal.dot(d0_ + alpha1 * d1_ + alpha2 * d2_);
    return {Vec3(1.0 - alpha1 - alpha2, alpha1, alpha2), slice.t * displacement_unit_, to_slope(slope)};
}

// N(t) has two factors of length and J one more of direction; in this order no product overflows or underflows unless
// the slope does.
double InverseDisplacement::to_slope(double scaled) const {
    const double slope = scaled * length_unit_ * direction_unit_ * length_unit_;
    return slope == 0.0 && scaled != 0.0 ? std::copysign(std::numeric_limits<double>::denorm_min(), scaled) : slope;
}

// Whether N is zero at some t within the uncertainty: |N(t + r) - N(t)| <= |N'(t)| |r| + |t_DD| r^2.
bool InverseDisplacement::vanishes(const Slice& slice, double uncertainty) const {
    const Vec3 change = t_pd_ + 2.0 * slice.t * t_dd_;
    const double rounding = slice_epsilon * 2.0 * slice.size1 * slice.size2;
    return size(slice.normal) <= (size(change) + uncertainty * size(t_dd_)) * uncertainty + rounding;
}

// Whether q is on the line, or the point, to which a slice has shrunk: it is if it is within `slack` of one of its
// edges or of all of its corners, where `slack` bounds how far corners move within the uncertainty.
bool InverseDisplacement::holds_point(const Slice& slice, double uncertainty) const {
    const double speed = size(d0_) + std::max(size_d1_, size_d2_);
    const double terms = size(slice.point) + std::abs(slice.t) * size(d0_) + std::max(slice.size1, slice.size2);
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
    const RealRoots roots = roots_near(cubic, error, {range.lo / displacement_unit_, range.hi / displacement_unit_});
    Preimages result;
    bool is_incomplete = roots.everywhere;
    for (const double t : roots) {
        const double model_t = t * displacement_unit_;
        if (!(range.lo <= model_t && model_t <= range.hi)) {
            continue;
        }
        const Slice at = slice(p0, t);
        const bool small = size(at.normal) <= surely_no_degenerate_slice * at.size1 * at.size2;
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
    const Vec3 direction = d0_ + preimage.alpha[1] * d1_ + preimage.alpha[2] * d2_;
    return preimage.t * (direction.norm() * direction_unit_);
}

} // namespace foldless
