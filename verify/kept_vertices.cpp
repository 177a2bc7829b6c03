#include <foldless/verify/kept_vertices.h>

#include <algorithm>
#include <numeric>

namespace foldless::verification {
namespace {

/// The used scan vertices sorted by coordinates, to be looked up by them.
class VerticesByPosition {
public:
    VerticesByPosition(const Scan& scan, const Adjacency& adjacency) : positions_(scan.positions) {
        for (std::size_t v = 0; v < scan.positions.size(); ++v) {
            if (!adjacency.faces_around(static_cast<std::int32_t>(v)).empty()) {
                order_.push_back(static_cast<std::int32_t>(v));
            }
        }
        std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
            const Vec3& p = positions_[a];
            const Vec3& q = positions_[b];
            return before(p, q) || (p == q && a < b);
        });
    }

    /// The only vertex at the position, or -1.
    [[nodiscard]] std::int32_t only_one_at(const Vec3& position) const {
        const auto first = std::lower_bound(order_.begin(), order_.end(), position,
                                            [&](std::int32_t a, const Vec3& p) { return before(positions_[a], p); });
        const bool found = first != order_.end() && positions_[*first] == position;
        const bool again = found && first + 1 != order_.end() && positions_[*(first + 1)] == position;
        return found && !again ? *first : -1;
    }

private:
    static bool before(const Vec3& p, const Vec3& q) {
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    }

    const std::vector<Vec3>& positions_;
    std::vector<std::int32_t> order_;
};

std::vector<std::int32_t> claims(const BaseMesh& base, const Scan& scan, const Adjacency& scan_adjacency) {
    if (!base.scan_vertex.empty()) {
        return base.scan_vertex;
    }
    const VerticesByPosition vertices(scan, scan_adjacency);
    std::vector<std::int32_t> result;
    for (const Vec3& position : base.positions) {
        result.push_back(vertices.only_one_at(position));
    }
    return result;
}

} // namespace

KeptVertices kept_vertices(const BaseMesh& base, const Scan& scan, const Adjacency& scan_adjacency,
                           Findings& findings) {
    KeptVertices kept{std::vector<std::int32_t>(base.positions.size(), -1),
                      std::vector<std::int32_t>(scan.positions.size(), -1)};
    const std::vector<std::int32_t> claimed = claims(base, scan, scan_adjacency);
    for (std::size_t b = 0; b < claimed.size(); ++b) {
        const std::int32_t s = claimed[b];
        if (s == -1) {
            continue;
        }
        const bool exists = s >= 0 && static_cast<std::size_t>(s) < scan.positions.size();
        if (!exists || base.positions[b] != scan.positions[s] || kept.base_of[s] >= 0) {
            findings.add({.violation = Violation::kept_vertex, .scan_vertex = s, .position = base.positions[b]});
            continue;
        }
        kept.scan_of[b] = s;
        kept.base_of[s] = static_cast<std::int32_t>(b);
    }
    return kept;
}

} // namespace foldless::verification
