/// \file
/// Whether all displacement directions of a patch see a scan face, in one question.
#pragma once

#include <foldless/predicates/scan_normal.h>
#include <foldless/predicates/vector.h>

#include <span>

namespace foldless {

/// A cone that holds a set of directions, and with them every interpolated one.
class DirectionCone {
public:
    /// Of any length, but not zero. An empty cone, or one wider than a half-space, sees nothing.
    explicit DirectionCone(std::span<const Vec3> directions);

    /// Whether every direction d in the cone certainly has d.n > 0; the normal must have unit length. With angles: that
    /// of n and the axis is less than a right angle minus that of the cone.
    [[nodiscard]] bool sees(const ScanNormal& normal) const {
        constexpr double slack = 1e-6; // far above the rounding of the sine
        return axis_.dot(normal.value()) > sine_ + slack + 4 * normal.error(axis_);
    }

private:
    Vec3 axis_ = Vec3::Zero();
    double sine_ = 2; ///< of the half angle, or 2 if that is not below a right angle
};

} // namespace foldless
