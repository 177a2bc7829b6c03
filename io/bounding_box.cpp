#include <foldless/io/bounding_box.h>

#include <cmath>
#include <limits>

namespace foldless {

double bounding_box_diagonal(const Scan& scan) {
    if (scan.faces.empty()) {
        return 0.0;
    }
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t vertex : face) {
            low = low.cwiseMin(scan.positions[vertex]);
            high = high.cwiseMax(scan.positions[vertex]);
        }
    }
    const Vec3 size = high - low;
    return std::hypot(size.x(), size.y(), size.z()); // coordinates may be too large to be squared
}

} // namespace foldless
