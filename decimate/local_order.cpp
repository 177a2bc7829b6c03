#include <foldless/decimate/local_order.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foldless {
namespace {

/// Steps along each axis of the box, as a power of two: three of them fill 63 bits.
constexpr int bits = 21;

/// The low bits of the number, two zeros after each.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32) & 0x001F00000000FFFF;
    x = (x | x << 16) & 0x001F0000FF0000FF;
    x = (x | x << 8) & 0x100F00F00F00F00F;
    x = (x | x << 4) & 0x10C30C30C30C30C3;
    return (x | x << 2) & 0x1249249249249249;
}

/// Where points lie along the Morton curve.
class MortonCurve {
public:
    explicit MortonCurve(const std::vector<Vec3>& points) : low_(points.front()) {
        Vec3 high = low_;
        for (const Vec3& p : points) {
            low_ = low_.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        // Halves, since the whole may overflow.
        per_half_ = std::ldexp(1.0, bits) / (high / 2 - low_ / 2).maxCoeff();
        if (!std::isfinite(per_half_)) {
            per_half_ = 0; // all in one point, as far as that matters
        }
    }

    [[nodiscard]] std::uint64_t position(const Vec3& p) const {
        std::uint64_t result = 0;
        for (int k = 0; k < 3; ++k) {
            const double steps = (p[k] / 2 - low_[k] / 2) * per_half_;
            const auto step = static_cast<std::uint64_t>(std::min(steps, std::ldexp(1.0, bits) - 1));
            result |= spread(step) << k;
        }
        return result;
    }

private:
    Vec3 low_;
    double per_half_;
};

/// The numbers 0 to count - 1, sorted; what is equal keeps its order.
template <class Less>
std::vector<std::int32_t> sorted(std::size_t count, const Less& less) {
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), less);
    return order;
}

Triangle renumbered(const Triangle& face, const std::vector<std::int32_t>& new_index) {
    return {new_index[face[0]], new_index[face[1]], new_index[face[2]]};
}

Triangle from_smallest(Triangle face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

void renumber(std::vector<Triangle>& faces, const std::vector<std::int32_t>& new_index) {
    for (Triangle& face : faces) {
        face = renumbered(face, new_index);
    }
}

/// The values at these indices.
template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::int32_t>& indices) {
    std::vector<Value> result;
    result.reserve(indices.size());
    for (const std::int32_t index : indices) {
        result.push_back(values[index]);
    }
    return result;
}

bool lexicographically_less(const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

} // namespace

std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order) {
    std::vector<std::int32_t> result(order.size());
    for (std::size_t n = 0; n < order.size(); ++n) {
        result[order[n]] = static_cast<std::int32_t>(n);
    }
    return result;
}

LocalOrder local_order(const Scan& scan) {
    const MortonCurve curve(scan.positions);
    std::vector<std::uint64_t> along;
    along.reserve(scan.positions.size());
    for (const Vec3& p : scan.positions) {
        along.push_back(curve.position(p));
    }
    const auto comes_first = [&](std::int32_t a, std::int32_t b) {
        return along[a] != along[b] ? along[a] < along[b]
                                    : lexicographically_less(scan.positions[a], scan.positions[b]);
    };
    LocalOrder order{sorted(scan.positions.size(), comes_first), {}};
    const std::vector<std::int32_t> new_index = inverse(order.vertices);
    std::vector<Triangle> faces;
    faces.reserve(scan.faces.size());
    for (const Triangle& face : scan.faces) {
        faces.push_back(from_smallest(renumbered(face, new_index)));
    }
    order.faces = sorted(faces.size(), [&](std::int32_t a, std::int32_t b) { return faces[a] < faces[b]; });
    return order;
}

Scan in_order(Scan scan, const LocalOrder& order) {
    scan.positions = picked(scan.positions, order.vertices);
    renumber(scan.faces, inverse(order.vertices));
    scan.faces = picked(scan.faces, order.faces);
    return scan;
}

Scan as_before(Scan scan, const LocalOrder& order) {
    scan.positions = picked(scan.positions, inverse(order.vertices));
    renumber(scan.faces, order.vertices);
    scan.faces = picked(scan.faces, inverse(order.faces));
    return scan;
}

} // namespace foldless
