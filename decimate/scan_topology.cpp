#include <foldless/decimate/scan_topology.h>

#include <foldless/io/corner.h>

#include <algorithm>

namespace foldless {
ScanTopology::ScanTopology(const Scan& scan) : offsets_(scan.positions.size() + 1, 0), faces_(3 * scan.faces.size()) {
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t v : face) {
            ++offsets_[v + 1];
        }
    }
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        offsets_[v + 1] += offsets_[v];
    }
    std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t f = 0; f < scan.faces.size(); ++f) {
        for (const std::int32_t v : scan.faces[f]) {
            faces_[next[v]++] = static_cast<std::int32_t>(f);
        }
    }
    for (const Triangle& face : scan.faces) {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = face[k];
            const std::int32_t b = face[(k + 1) % 3];
            const auto around = faces_around(b);
            const bool has_twin = std::any_of(around.begin(), around.end(),
                                              [&](std::int32_t f) { return runs_along(scan.faces[f], b, a); });
            if (!has_twin) {
                border_successor_.resize(scan.positions.size(), -1); // which changes it the first time only
                border_successor_[a] = b;
            }
        }
    }
}

} // namespace foldless
