/// \file
/// The points and directions of every layer, and the two small aggregates that the predicates speak of.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace foldless {

using Vec3 = Eigen::Vector3d;

/// The corners of a triangle of the scan, in its orientation; model units.
using ScanTriangle = std::array<Vec3, 3>;

/// A triangle T of the base mesh with its displacement directions: a point with barycentric coordinates alpha and
/// displacement t lies at sum alpha_i (v_i + t d_i). The direction is interpolated, not renormalised.
/// (Maggiordomo et al. 2023, eq. 5)
struct BaseTriangle {
    std::array<Vec3, 3> v; ///< corners, model units
    std::array<Vec3, 3> d; ///< displacement directions, any length

    /// a_i(t) = v_i + t d_i, a corner of the slice at displacement t (eq. 7).
    [[nodiscard]] Vec3 corner(int i, double t) const { return v[i] + t * d[i]; }
};

/// A closed range of displacements t, in units of the interpolated direction; lo <= hi.
struct Range {
    double lo;
    double hi;
};

} // namespace foldless
