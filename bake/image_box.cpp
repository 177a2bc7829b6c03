#include <foldless/bake/image_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// The rounding of what is computed here is some 1e-16 of the sizes that go in, and a million times that at most where
/// they cancel as far as is let through.
constexpr double margin = 1e-6;
constexpr double worst_cancellation = 1e9;

/// Halvings of the box: each narrows it further, but less and less.
constexpr int rounds = 2;

constexpr AlphaBox whole_face{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};

/// A convex polygon on the base face; a triangle that is clipped by eight lines.
class Polygon {
public:
    /// The whole face.
    Polygon() : corners_{Vec3::Unit(0), Vec3::Unit(1), Vec3::Unit(2)}, size_(3) {}

    /// Keeps the part where the linear function with these values at the corners of the face is at least 0.
    void clip(const Vec3& values) {
        std::array<Vec3, capacity> kept;
        int count = 0;
        for (int i = 0; i < size_; ++i) {
            const Vec3& a = corners_[i];
            const Vec3& b = corners_[(i + 1) % size_];
            const double at_a = values.dot(a);
            const double at_b = values.dot(b);
            if (at_a >= 0.0 && count < capacity) {
                kept[count++] = a;
            }
            if ((at_a < 0.0) != (at_b < 0.0) && count < capacity) {
                kept[count++] = a + at_a / (at_a - at_b) * (b - a);
            }
        }
        std::copy_n(kept.begin(), count, corners_.begin());
        size_ = count;
    }

    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const Vec3* begin() const { return corners_.data(); }
    [[nodiscard]] const Vec3* end() const { return corners_.data() + size_; }

private:
    static constexpr int capacity = 3 + 2 + 6 * rounds; // each line adds one corner at most
    std::array<Vec3, capacity> corners_;
    int size_;
};

/// l and m at the corners of the base face.
struct Plane {
    Vec3 l;
    Vec3 m;
    double slack; ///< of l, in its unit

    Plane(const BaseTriangle& triangle, const ScanTriangle& scan) {
        const Vec3 n = (scan[1] - scan[0]).cross(scan[2] - scan[0]);
        double size = 0.0;
        for (int i = 0; i < 3; ++i) {
            l[i] = (triangle.v[i] - scan[0]).dot(n);
            m[i] = triangle.d[i].dot(n);
            size = std::max({size, triangle.v[i].norm(), scan[i].norm()});
        }
        constexpr double share = 1e-12;
        slack = share * size * n.norm();
    }
};

/// The displacements of the polygon's corners into the plane, widened a little, where all of them have N.n > 0.
std::optional<Range> displacements(const Polygon& polygon, const Plane& plane) {
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Vec3& alpha : polygon) {
        const double m = plane.m.dot(alpha);
        if (!(m > 0.0)) {
            return std::nullopt;
        }
        const double l = plane.l.dot(alpha);
        range.lo = std::min(range.lo, (-l - plane.slack) / m);
        range.hi = std::max(range.hi, (-l + plane.slack) / m);
    }
    return range;
}

AlphaBox box_within(const BaseTriangle& triangle, Range range, const ScanTriangle& scan) {
    const double middle = 0.5 * (range.lo + range.hi);
    const double half = 0.5 * (range.hi - range.lo);
    if (!std::isfinite(half)) {
        return whole_face;
    }
    const Vec3 origin = triangle.corner(0, middle);
    const Vec3 edge1 = triangle.corner(1, middle) - origin;
    const Vec3 edge2 = triangle.corner(2, middle) - origin;
    const Vec3 mean = (triangle.d[0] + triangle.d[1] + triangle.d[2]) / 3.0;
    const double volume = mean.dot(edge1.cross(edge2));
    const std::array<Vec3, 2> crosses{edge2.cross(mean), mean.cross(edge1)};
    const double size = std::max({origin.norm(), edge1.norm(), edge2.norm(), scan[0].norm()});
    const double steepest = std::max(crosses[0].norm(), crosses[1].norm());
    if (!(volume > 0.0) || steepest * size > worst_cancellation * volume) {
        return whole_face;
    }
    // The gradients of alpha in the slice, seen along the mean direction.
    const Vec3 gradient1 = crosses[0] / volume;
    const Vec3 gradient2 = crosses[1] / volume;
    const std::array<Vec3, 3> gradients{-gradient1 - gradient2, gradient1, gradient2};
    AlphaBox box;
    for (int k = 0; k < 3; ++k) {
        const double at_origin = k == 0 ? 1.0 : 0.0;
        const auto at = [&](const Vec3& q) { return at_origin + gradients[k].dot(q - origin); };
        const auto [least, most] = std::minmax({at(scan[0]), at(scan[1]), at(scan[2])});
        const auto moved = [&](const Vec3& d) { return std::abs(gradients[k].dot(d - mean)); };
        const double shift = half * std::max({moved(triangle.d[0]), moved(triangle.d[1]), moved(triangle.d[2])});
        box.lo[k] = least - shift - margin;
        box.hi[k] = most + shift + margin;
    }
    return box;
}

/// The values of alpha_k - bound at the corners of the face, or those of bound - alpha_k.
Vec3 above(int k, double bound) {
    return Vec3::Unit(k) - Vec3::Constant(bound);
}

/// The box around the polygon, widened a little.
AlphaBox box_around(const Polygon& polygon) {
    AlphaBox box{{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
    for (const Vec3& alpha : polygon) {
        for (int k = 0; k < 3; ++k) {
            box.lo[k] = std::min(box.lo[k], alpha[k] - margin);
            box.hi[k] = std::max(box.hi[k], alpha[k] + margin);
        }
    }
    return box;
}

} // namespace

std::optional<AlphaBox> image_box(const BaseTriangle& triangle, Range range, const ScanTriangle& scan) {
    const Plane plane(triangle, scan);
    const Vec3 slack = Vec3::Constant(plane.slack);
    Polygon polygon;
    polygon.clip(plane.l + range.hi * plane.m + slack);    // t <= hi
    polygon.clip(-(plane.l + range.lo * plane.m) + slack); // t >= lo
    for (int round = 0; round < rounds && !polygon.empty(); ++round) {
        if (const std::optional<Range> narrower = displacements(polygon, plane)) {
            range = {std::max(range.lo, narrower->lo), std::min(range.hi, narrower->hi)};
        }
        if (range.lo > range.hi) {
            return std::nullopt;
        }
        const AlphaBox box = box_within(triangle, range, scan);
        for (int k = 0; k < 3; ++k) {
            polygon.clip(above(k, box.lo[k]));
            polygon.clip(-above(k, box.hi[k]));
        }
    }
    return polygon.empty() ? std::nullopt : std::optional(box_around(polygon));
}

} // namespace foldless
