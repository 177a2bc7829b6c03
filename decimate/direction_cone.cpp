#include <foldless/decimate/direction_cone.h>

#include <algorithm>
#include <cmath>

namespace foldless {

DirectionCone::DirectionCone(std::span<const Vec3> directions) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& d : directions) {
        sum += d;
    }
    const double length = sum.norm();
    if (!(length > 0)) {
        return;
    }
    axis_ = sum / length;
    double cosine = 1;
    for (const Vec3& d : directions) {
        cosine = std::min(cosine, d.dot(axis_) / d.norm());
    }
    sine_ = cosine > 0 ? std::sqrt(1 - cosine * cosine) : 2;
}

} // namespace foldless
