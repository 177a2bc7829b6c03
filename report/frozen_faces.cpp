#include <foldless/report/frozen_faces.h>

#include <algorithm>
#include <vector>

namespace foldless {

namespace {

/// The same oriented face, its smallest vertex first.
Triangle smallest_first(Triangle face) {
    std::rotate(face.begin(), std::ranges::min_element(face), face.end());
    return face;
}

/// The faces with range [0, 0] and three kept corners, by the scan vertices that these are.
std::vector<Triangle> candidates(const BaseMesh& base) {
    std::vector<Triangle> found;
    for (std::size_t f = 0; f < base.ranges.size(); ++f) {
        Triangle face = base.faces[f];
        std::ranges::transform(face, face.begin(), [&](std::int32_t vertex) { return base.scan_vertex[vertex]; });
        const bool is_kept = std::ranges::min(face) >= 0;
        if (is_kept && base.ranges[f].lo == 0.0 && base.ranges[f].hi == 0.0) {
            found.push_back(smallest_first(face));
        }
    }
    return found;
}

} // namespace

std::size_t count_frozen_faces(const BaseMesh& base, const Scan& scan) {
    if (base.scan_vertex.empty()) {
        return 0;
    }
    std::vector<Triangle> possible = candidates(base);
    std::ranges::sort(possible);
    return static_cast<std::size_t>(std::ranges::count_if(
        scan.faces, [&](const Triangle& face) { return std::ranges::binary_search(possible, smallest_first(face)); }));
}

} // namespace foldless
