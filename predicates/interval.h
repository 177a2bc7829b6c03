/// \file
/// Interval arithmetic for the signs that plain doubles cannot decide. For the sources of this layer only.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <CGAL/Interval_nt.h>

#include <array>

namespace foldless {

/// Rounds upwards as long as it lives; every computation with Interval needs one in scope.
using Interval = CGAL::Interval_nt<false>;
using UpwardRounding = Interval::Protector;

using IntervalVec3 = std::array<Interval, 3>;

inline IntervalVec3 exactly(const Vec3& v) {
    return {Interval(v.x()), Interval(v.y()), Interval(v.z())};
}
inline IntervalVec3 operator-(const IntervalVec3& a, const IntervalVec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline IntervalVec3 operator+(const IntervalVec3& a, const IntervalVec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline IntervalVec3 operator*(const Interval& s, const IntervalVec3& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline IntervalVec3 cross(const IntervalVec3& a, const IntervalVec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Interval dot(const IntervalVec3& a, const IntervalVec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The sign of every number in the interval, if they all have the same.
inline Sign sign_of(const Interval& x) {
    if (x.inf() > 0) {
        return Sign::positive;
    }
    if (x.sup() < 0) {
        return Sign::negative;
    }
    return x.inf() == 0 && x.sup() == 0 ? Sign::zero : Sign::undecided;
}

} // namespace foldless
