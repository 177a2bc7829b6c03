/// \file
/// Prismoids on which J > 0 and points to ask about, and how answers of the predicates are compared with the oracle's.
#pragma once

#include "prismoid_oracle.h"
#include "random_triangles.h"

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/real_root.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/sign_counts.h>

#include <CGAL/Gmpq.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foldless {

inline Sign as_sign(int sign) {
    return sign > 0 ? Sign::positive : sign < 0 ? Sign::negative : Sign::zero;
}

inline oracle::Rational rational(const Exact& x) {
    return oracle::Rational(static_cast<CGAL::Gmpq>(x).mpq());
}

/// Whether the displacement is that root, and lies within its bounds.
inline bool is_root(const Displacement& t, const oracle::Root& root) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Range bounds = t.bounds();
    const bool within_bounds = (bounds.lo == -infinity || oracle::compare(root, oracle::root_at(bounds.lo)) >= 0) &&
                               (bounds.hi == infinity || oracle::compare(root, oracle::root_at(bounds.hi)) <= 0);
    const RealRoot exact = t.exact();
    if (exact.is_rational_value()) {
        return within_bounds && oracle::compare(root, oracle::root_at(rational(exact.lo()))) == 0;
    }
    oracle::Polynomial f;
    for (const Exact& c : exact.polynomial().coefficients()) {
        f.push_back(rational(c));
    }
    return within_bounds && oracle::compare(root, oracle::root_at(rational(exact.lo()))) > 0 &&
           oracle::compare(root, oracle::root_at(rational(exact.hi()))) < 0 && oracle::sign_at(root, f) == 0;
}

/// Filters are off as long as it lives.
class WithoutFilters {
public:
    WithoutFilters() { set_filters_enabled(false); }
    ~WithoutFilters() { set_filters_enabled(true); }
    WithoutFilters(const WithoutFilters&) = delete;
    WithoutFilters& operator=(const WithoutFilters&) = delete;
};

/// A base face with its range.
struct Prismoid {
    BaseTriangle triangle;
    Range range;
};

/// How the corners and the directions of a sample are made; all but the first have few digits, so that ties happen.
enum class Sample {
    random,
    dyadic,         ///< on a coarse grid
    parallel,       ///< directions of one line, of different lengths: all cubics are quadratics or lines
    equal,          ///< a prism
    converging,     ///< a pyramid, cut below its top
    random_prism,   ///< equal directions with all digits
    nearly_parallel ///< with cubic coefficients far smaller than the others
};
constexpr int samples = 7;

/// Triangles around a common corner, counter-clockwise: corner 0 of each is the common one in the first sample, and
/// the corners are rotated after that. The ranges have J > 0 and hold 0.
class Samples : public RandomTriangles {
public:
    explicit Samples(unsigned seed) : RandomTriangles(seed) {}

    int integer(int lo, int hi) { return lo + static_cast<int>(std::floor(number(0, hi - lo + 1 - 1e-9))); }
    /// A multiple of 1 / parts in [lo, hi].
    double fraction(int parts, int lo, int hi) { return integer(lo * parts, hi * parts) / static_cast<double>(parts); }

    Vec3 direction(Sample sample, const Vec3& v) {
        switch (sample) {
        case Sample::random: return Vec3(0, 0, 1) + vector(0.4);
        case Sample::dyadic: return {fraction(4, -1, 1), fraction(4, -1, 1), fraction(2, 1, 2)};
        case Sample::parallel: return fraction(4, 1, 2) * Vec3(0.25, -0.5, 1);
        case Sample::equal: return {0.5, 0.25, 1};
        case Sample::converging: return (Vec3(0.25, 0.125, 4) - v) * 0.5;
        case Sample::random_prism: return {0.3, -0.123456789, 0.7777};
        case Sample::nearly_parallel: return Vec3(0, 0, 1) + std::ldexp(1.0, -integer(8, 50)) * vector();
        }
        return Vec3::Zero();
    }

    /// A fan of n triangles around a vertex; a closed one.
    std::vector<Prismoid> fan(Sample sample, int n) {
        static const double steps[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
        const bool fine = sample == Sample::random || sample == Sample::random_prism;
        for (;;) {
            std::vector<Vec3> v{fine ? vector(0.2) : Vec3(0, 0, 0)};
            for (int i = 0; i < n; ++i) {
                const int at = i * 8 / n;
                const Vec3 corner(steps[at][0], steps[at][1], fine ? 0 : fraction(4, -1, 1) / 2);
                v.push_back(fine ? Vec3(corner + vector(0.25)) : corner);
            }
            std::vector<Vec3> d;
            for (const Vec3& corner : v) {
                d.push_back(direction(sample, corner));
            }
            std::vector<Prismoid> result;
            for (int i = 0; i < n; ++i) {
                const int a = 1 + i;
                const int b = 1 + (i + 1) % n;
                Prismoid prismoid{{{v[0], v[a], v[b]}, {d[0], d[a], d[b]}}, {}};
                if (!choose_range(prismoid)) {
                    break;
                }
                result.push_back(prismoid);
            }
            if (static_cast<int>(result.size()) == n) {
                return result;
            }
        }
    }

    Prismoid prismoid(Sample sample) { return fan(sample, integer(4, 8))[0]; }

    /// A few parts of the triangle, its border and its corners among them.
    Vec3 coarse_barycentric() {
        const int parts = 4;
        const int a = integer(0, parts);
        const int b = integer(0, parts - a);
        return Vec3(a, b, parts - a - b) / parts;
    }

private:
    bool choose_range(Prismoid& prismoid) {
        for (double reach = 1; reach > 0.1; reach /= 2) {
            prismoid.range = {-reach * fraction(4, 0, 1), reach * fraction(4, 0, 1)};
            if (oracle::jacobian_is_positive(prismoid.triangle, prismoid.range)) {
                return true;
            }
        }
        return false;
    }
};

} // namespace foldless
