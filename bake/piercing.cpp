#include <foldless/bake/piercing.h>

namespace foldless {

std::optional<Piercing> piercing(const SampleLine& line, const ScanTriangle& triangle) {
    Vec3 weights;
    for (int k = 0; k < 3; ++k) {
        const SampleLine::Side side = line.side(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
        if (side.sign == Sign::negative) {
            return std::nullopt;
        }
        weights[k] = side.value;
    }
    // Their exact sum is d.n: zero only if the line lies in the plane, as none is negative.
    const double sum = weights.sum();
    if (!(sum > 0.0)) {
        return std::nullopt;
    }
    weights /= sum;
    const Vec3 point = weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2];
    const Vec3& d = line.direction();
    return Piercing{weights, (point - line.point()).dot(d) / d.squaredNorm()};
}

} // namespace foldless
