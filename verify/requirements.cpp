#include <foldless/verify/requirements.h>

#include <foldless/io/defects.h>
#include <foldless/io/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace foldless::verification {
namespace {

void require(bool condition, const std::string& reason) {
    if (!condition) {
        throw RefusedMesh("base mesh: " + reason);
    }
}

bool is_absent_or(std::size_t size, std::size_t wanted) {
    return size == 0 || size == wanted;
}

bool all_finite(const std::vector<Vec3>& vectors) {
    return std::ranges::all_of(vectors, [](const Vec3& v) { return v.allFinite(); });
}

bool all_intervals(const std::vector<Range>& ranges) {
    return std::ranges::all_of(ranges, [](const Range& range) {
        return std::isfinite(range.lo) && std::isfinite(range.hi) && range.lo <= range.hi;
    });
}

} // namespace

void require_usable(const BaseMesh& base, const Scan& scan) {
    require_no_defects(scan);
    require_no_defects(Scan{base.positions, base.faces, base.float32});
    const std::size_t vertices = base.positions.size();
    const std::size_t faces = base.faces.size();
    require(!base.directions.empty() || !base.face_directions.empty(), "no displacement directions");
    require(is_absent_or(base.directions.size(), vertices), "the number of directions is not that of the vertices");
    require(is_absent_or(base.face_directions.size(), faces), "the number of face directions is not that of the faces");
    require(is_absent_or(base.ranges.size(), faces), "the number of ranges is not that of the faces");
    require(is_absent_or(base.scan_vertex.size(), vertices), "the number of scan vertices is not that of the vertices");
    require(all_finite(base.directions) && all_finite(base.face_directions), "a direction is not finite");
    require(all_intervals(base.ranges), "a range is not finite, or ends before it begins");
}

} // namespace foldless::verification
