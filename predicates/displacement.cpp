#include <foldless/predicates/displacement.h>

#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/real_root.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace foldless {
namespace {

/// Two doubles around the root, or one that is it.
Range bounds_of(const RealRoot& root) {
    const std::pair<double, double> below = CGAL::to_interval(root.lo());
    if (root.is_rational_value()) {
        // Of a number that is a double, CGAL may give that and the next one.
        for (const double x : {below.first, below.second}) {
            if (std::isfinite(x) && sign_of(root.lo() - Exact(x)) == Sign::zero) {
                return {x, x};
            }
        }
        return {below.first, below.second};
    }
    return {below.first, CGAL::to_interval(root.hi()).second};
}

bool is_strictly_between(const RealRoot& root, double x) {
    return std::isfinite(x) && sign_of(root.lo() - Exact(x)) == Sign::negative &&
           sign_of(root.hi() - Exact(x)) == Sign::positive;
}

/// The root of the cubic of q within the bounds that is the displacement of a point of the triangle. Nearly always
/// there is no other root so near.
RealRoot root_inside(const BaseTriangle& triangle, const Vec3& q, Range bounds) {
    const ExactPolynomial c = polynomial(cubic<Exact>(triangle, q));
    std::vector<RealRoot> roots = real_roots_in(c, Exact(bounds.lo), Exact(bounds.hi));
    const auto is_inside = [&](const RealRoot& root) {
        for (int k = 0; k < 3; ++k) {
            const auto alpha = polynomial(side<Exact>(triangle, k, q, exactly<Exact>(triangle.d[0])));
            if (sign_at(root, alpha) == Sign::negative) {
                return false;
            }
        }
        return sign_at(root, c.derivative()) == Sign::positive;
    };
    const auto found = roots.size() == 1 ? roots.begin() : std::find_if(roots.begin(), roots.end(), is_inside);
    if (found == roots.end()) {
        throw std::logic_error("displacement: there is no root within the bounds");
    }
    return std::move(*found);
}

/// The root of the quadratic within the bounds at which the line is on the wall between its corners, and between its
/// own ends. Nearly always there is no other root so near.
RealRoot root_on_wall(const BaseTriangle& triangle, int k, const ScanLine& line, Range bounds) {
    const auto side_of = [&](int corner) { return polynomial(side<Exact>(triangle, corner, line)); };
    std::vector<RealRoot> roots = real_roots_in(side_of(k), Exact(bounds.lo), Exact(bounds.hi));
    const auto is_met = [&](const RealRoot& root) {
        // alpha = side / w at s = C_from / w = 1 + C_to / w; and where w = 0 all of these vanish, as the line lies in
        // the slice.
        const Sign w = sign_at(root, polynomial(rise<Exact>(triangle, line)));
        const auto has_sign = [&](const ExactPolynomial& f, Sign expected) {
            const Sign sign = sign_at(root, f);
            return sign == Sign::zero || (sign == expected && w != Sign::zero);
        };
        return has_sign(side_of((k + 1) % 3), w) && has_sign(side_of((k + 2) % 3), w) &&
               has_sign(polynomial(cubic<Exact>(triangle, *line.from)), w) &&
               has_sign(polynomial(cubic<Exact>(triangle, *line.to)), -w);
    };
    const auto found = roots.size() == 1 ? roots.begin() : std::find_if(roots.begin(), roots.end(), is_met);
    if (found == roots.end()) {
        throw std::logic_error("displacement: the line does not meet the wall within the bounds");
    }
    return std::move(*found);
}

} // namespace

Displacement Displacement::of_point(const BaseTriangle& triangle, const Vec3& q, Range bounds) {
    return {bounds, &triangle, -1, {&q, nullptr}};
}

Displacement Displacement::at_wall(const BaseTriangle& triangle, int k, const ScanLine& line, Range bounds) {
    return {bounds, &triangle, k, line};
}

Displacement Displacement::of_root(RealRoot root) {
    // Down to the resolution of doubles, so that filters can use the bounds; halving any further tells them nothing.
    // Halving may pass by a root that is a double for ever, and CGAL's bounds of numbers that underflow are wide.
    constexpr double least = 0x1p-1000;
    if (is_strictly_between(root, 0.0) && root.polynomial().sign_at(Exact(0)) == Sign::zero) {
        root = RealRoot(Exact(0));
    }
    while (!root.is_rational_value()) {
        const Range bounds = bounds_of(root);
        const double middle = std::nextafter(bounds.lo, bounds.hi);
        if (std::nextafter(middle, bounds.hi) >= bounds.hi || bounds.hi - bounds.lo < least) {
            if (is_strictly_between(root, middle) && root.polynomial().sign_at(Exact(middle)) == Sign::zero) {
                root = RealRoot(Exact(middle));
            }
            break;
        }
        root.refine();
    }
    Displacement result(bounds_of(root), nullptr, -1, {nullptr, nullptr});
    if (!result.is_double()) {
        result.root_ = std::make_shared<const RealRoot>(std::move(root));
    }
    return result;
}

RealRoot Displacement::exact() const {
    if (root_) {
        return *root_;
    }
    const Exact lo(bounds_.lo);
    if (is_double()) {
        return RealRoot(lo);
    }
    if (wall_ >= 0) {
        return root_on_wall(*triangle_, wall_, line_, bounds_);
    }
    return root_inside(*triangle_, *line_.from, bounds_);
}

void Displacement::keep_exact() {
    if (!root_ && !is_double()) {
        root_ = std::make_shared<const RealRoot>(exact());
    }
}

Sign compare(const Displacement& a, const Displacement& b) {
    if (filters_enabled() || (a.is_double() && b.is_double())) {
        const Range x = a.bounds();
        const Range y = b.bounds();
        if (x.hi < y.lo || x.lo > y.hi) {
            count_filtered();
            return x.hi < y.lo ? Sign::negative : Sign::positive;
        }
        if (a.is_double() && b.is_double()) {
            count_filtered();
            return Sign::zero;
        }
    }
    count_exact();
    return compare(a.exact(), b.exact());
}

Sign within(const Displacement& t, Range range) {
    const Sign above = std::isfinite(range.lo) ? compare(t, Displacement(range.lo)) : Sign::positive;
    const Sign below = std::isfinite(range.hi) ? compare(Displacement(range.hi), t) : Sign::positive;
    if (above == Sign::negative || below == Sign::negative) {
        return Sign::negative;
    }
    return above == Sign::zero || below == Sign::zero ? Sign::zero : Sign::positive;
}

} // namespace foldless
