/// \file
/// A displacement t as an exact real number: where a scan point lies, or where a scan edge crosses a wall.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <memory>

namespace foldless {

class RealRoot;

/// The straight line from one scan point to another; refers to both.
struct ScanLine {
    const Vec3* from;
    const Vec3* to;
};

/// A double, a root of the cubic of a point, or a root of the quadratic of a line and a wall. (docs/certificate.md) It
/// is known within two doubles; what they cannot decide is decided with the polynomial in exact arithmetic.
///
/// Refers to the triangle and the points of which it is a root; they must outlive it.
class Displacement {
public:
    /// The number 0.
    Displacement() : bounds_{0.0, 0.0} {}
    /// The number t itself. \pre it is finite
    explicit Displacement(double t) : bounds_{t, t} {}

    /// The only root within the bounds of the cubic of q on the triangle that lies inside it, where J > 0. \pre there
    /// is one
    static Displacement of_point(const BaseTriangle& triangle, const Vec3& q, Range bounds);
    /// The only root within the bounds of the quadratic of the line and the wall opposite corner k at which they meet
    /// between their ends; or the only root, wherever they meet. \pre there is one
    static Displacement at_wall(const BaseTriangle& triangle, int k, const ScanLine& line, Range bounds);
    /// A root that is already isolated.
    static Displacement of_root(RealRoot root);

    /// t lies within these, and is them if they are equal.
    [[nodiscard]] Range bounds() const { return bounds_; }
    [[nodiscard]] bool is_double() const { return bounds_.lo == bounds_.hi; }
    /// The middle of the bounds.
    [[nodiscard]] double approximate() const { return bounds_.lo + 0.5 * (bounds_.hi - bounds_.lo); }

    /// For the sources of this layer.
    [[nodiscard]] RealRoot exact() const;
    /// Keeps what exact() gives, for one that will be compared again.
    void keep_exact();

private:
    Displacement(Range bounds, const BaseTriangle* triangle, int wall, ScanLine line)
        : bounds_(bounds), triangle_(triangle), wall_(wall), line_(line) {}

    Range bounds_;
    const BaseTriangle* triangle_ = nullptr;
    int wall_ = -1; ///< the corner opposite the wall, or -1 for the cubic of *line_.from
    ScanLine line_{nullptr, nullptr};
    std::shared_ptr<const RealRoot> root_; ///< where the bounds alone do not tell the root from others
};

/// The sign of a - b.
[[nodiscard]] Sign compare(const Displacement& a, const Displacement& b);

/// Whether t lies in the range: positive inside, zero at an end, negative outside.
[[nodiscard]] Sign within(const Displacement& t, Range range);

} // namespace foldless
