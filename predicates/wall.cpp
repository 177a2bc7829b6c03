#include <foldless/predicates/wall.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {

Wall::Wall(const BaseTriangle& triangle, int opposite) {
    const int i = (opposite + 1) % 3;
    const int j = (opposite + 2) % 3;
    const Vec3 r = triangle.v[j] - triangle.v[i];
    const Vec3 delta = triangle.d[j] - triangle.d[i];
    const Vec3& d_i = triangle.d[i];
    w0_ = r.cross(d_i);
    w1_ = r.cross(delta);
    w2_ = delta.cross(d_i);
    // Products that may underflow have no bound.
    const bool counted = std::min(max_norm(r), max_norm(d_i)) >= least_length;
    size_ = counted ? max_norm(r) * (max_norm(d_i) + max_norm(delta)) : std::numeric_limits<double>::infinity();
    spread_ = max_norm(delta) * max_norm(d_i);
}

bool Wall::is_passed_one_way(const Vec3& e, Range range) const {
    const double p0 = e.dot(w0_);
    const double p1 = e.dot(w1_);
    const double p2 = e.dot(w2_);
    // The value is p0 + lambda p1 + t p2, linear in lambda and in t. Each component of a cached product is off by at
    // most 9 roundings of its size (as in ScanNormal), the dot product with e (three more, and the rounding of e
    // itself) and the outer sums by 6 more; 20 covers all with their second-order terms. Where w2 or its product with e
    // underflows, a long reach makes much of what was lost: less than this, which is no subnormal number, as products
    // with those take a hundred times as long.
    const double reach = std::max(std::abs(range.lo), std::abs(range.hi));
    const double underflow = std::numeric_limits<double>::min() * (1 + reach * (1 + sum_norm(e)));
    const double error = 20 * unit_roundoff * sum_norm(e) * (2 * size_ + reach * 2 * spread_) + underflow;
    const double low_t = std::min(range.lo * p2, range.hi * p2);
    const double high_t = std::max(range.lo * p2, range.hi * p2);
    return p0 + std::min(0.0, p1) + low_t > error || p0 + std::max(0.0, p1) + high_t < -error;
}

} // namespace foldless
