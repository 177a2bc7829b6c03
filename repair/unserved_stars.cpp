#include <foldless/repair/unserved_stars.h>

#include <foldless/predicates/scan_normal.h>
#include <foldless/predicates/visible_direction.h>
#include <foldless/repair/dropping.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

namespace {

/// The faces around each vertex, in ascending order.
class Stars {
public:
    explicit Stars(const Scan& scan) : start_(scan.positions.size() + 1, 0), faces_(3 * scan.faces.size()) {
        for (const Triangle& face : scan.faces) {
            for (const std::int32_t vertex : face) {
                ++start_[vertex];
            }
        }
        // First the ends of the stars, which filling from the last face on turns into their starts.
        std::size_t end = 0;
        for (std::size_t& star : start_) {
            end += star;
            star = end;
        }
        for (std::size_t face = scan.faces.size(); face-- > 0;) {
            for (const std::int32_t vertex : scan.faces[face]) {
                faces_[--start_[vertex]] = static_cast<std::int32_t>(face);
            }
        }
    }

    [[nodiscard]] std::span<const std::int32_t> around(std::size_t vertex) const {
        return {faces_.data() + start_[vertex], start_[vertex + 1] - start_[vertex]};
    }

private:
    std::vector<std::size_t> start_;
    std::vector<std::int32_t> faces_;
};

std::vector<Vec3> unit_normals(const Scan& scan) {
    std::vector<Vec3> normals;
    normals.reserve(scan.faces.size());
    for (const Triangle& face : scan.faces) {
        const ScanTriangle triangle{scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
        normals.push_back(ScanNormal(triangle).normalised().value());
    }
    return normals;
}

} // namespace

bool drop_unserved_stars(Scan& scan, RepairCounts& counts) {
    const Stars stars(scan);
    const std::vector<Vec3> normals = unit_normals(scan);
    std::vector<std::uint8_t> dropped(scan.faces.size(), 0);
    std::size_t unserved = 0;
    std::vector<Vec3> seen;
    for (std::size_t vertex = 0; vertex < scan.positions.size(); ++vertex) {
        seen.clear();
        for (const std::int32_t face : stars.around(vertex)) {
            seen.push_back(normals[face]);
        }
        if (seen.empty() || most_visible_direction(seen)) {
            continue;
        }
        ++unserved;
        for (const std::int32_t face : stars.around(vertex)) {
            dropped[face] = 1;
        }
    }
    counts.unserved_vertices += unserved;
    counts.unserved_faces += drop_marked_faces(scan, dropped);
    return unserved > 0;
}

} // namespace foldless
