/// \file
/// Where a scan point lies in the prismoid of a base triangle, decided exactly.
#pragma once

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <optional>

namespace foldless {

/// Walls of a triangle: bit k for the wall opposite corner k.
using Walls = unsigned;

[[nodiscard]] constexpr Walls wall_bit(int k) {
    return 1U << static_cast<unsigned>(k);
}

/// Both walls that meet in the pillar of corner k.
[[nodiscard]] constexpr Walls walls_at_corner(int k) {
    return 7U & ~wall_bit(k);
}

/// A point of a prismoid.
struct PrismoidPoint {
    Displacement t;
    Walls walls = 0; ///< those on which it lies: alpha_k = 0 exactly
};

/// A triangle over a range on which J > 0, with the products that many points share.
class PointFinder {
public:
    /// Refers to the triangle. \pre jacobian_on(triangle, range) is positive
    PointFinder(const BaseTriangle& triangle, Range range);

    /// The place of q in T x range, its border included, if there is one: at most one, as J > 0. Refers to q. Exact:
    /// the roots of the cubic within the range are all found, and the signs of their barycentric coordinates. Finite
    /// input is assumed.
    [[nodiscard]] std::optional<PrismoidPoint> find(const Vec3& q) const;

private:
    /// What filters know.
    struct Filtered {
        bool is_decided;
        std::optional<PrismoidPoint> place;
    };
    [[nodiscard]] Filtered filtered_find(const Vec3& q) const;

    const BaseTriangle* triangle_;
    Range range_;
    InverseDisplacement inverse_;
};

/// The sign of alpha_k at the solution for q whose displacement is t. Exact. \pre J > 0 at t
[[nodiscard]] Sign sign_of_coordinate(const BaseTriangle& triangle, int k, const Vec3& q, const Displacement& t);

/// The sign of m(alpha) = d(alpha).n at the place of q with displacement t, for the scan triangle: N.n > 0 of Collins &
/// Hilton 2002, eq. 4. Exact. \pre t is a root of the cubic of q with alpha >= 0 and J > 0
[[nodiscard]] Sign normal_condition_at(const BaseTriangle& triangle, const Vec3& q, const Displacement& t,
                                       const ScanTriangle& scan_triangle);

/// Where a line meets a wall.
struct WallPoint {
    int wall; ///< opposite this corner
    Displacement t;
    ScanLine line; ///< refers to its points
};

/// The same where an edge of the scan triangle meets a wall. Exact. \pre 0 <= lambda <= 1 on the wall
[[nodiscard]] Sign normal_condition_at_wall(const BaseTriangle& triangle, const WallPoint& point,
                                            const ScanTriangle& scan_triangle);

/// The place of a point as doubles, for the record: alpha and t are those of the exact place up to rounding.
struct RoundedPlace {
    Vec3 alpha;
    double t;
};
[[nodiscard]] RoundedPlace rounded_place(const BaseTriangle& triangle, const Vec3& q, const Displacement& t);

} // namespace foldless
