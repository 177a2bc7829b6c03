#include <foldless/repair/bad_faces.h>

#include <foldless/io/edge_table.h>
#include <foldless/io/zero_area.h>

#include <algorithm>

namespace foldless {

namespace {

using Count = std::size_t RepairCounts::*;

/// The count of the first flaw of a face, null if it has none.
Count flaw_of(const Scan& scan, const Triangle& face) {
    const std::size_t vertices = scan.positions.size();
    if (std::ranges::any_of(face, [&](std::int32_t v) { return v < 0 || static_cast<std::size_t>(v) >= vertices; })) {
        return &RepairCounts::out_of_range_faces;
    }
    if (!has_three_vertices(face, vertices)) {
        return &RepairCounts::repeated_index_faces;
    }
    const ScanTriangle triangle{scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
    if (!std::ranges::all_of(triangle, [](const Vec3& corner) { return corner.allFinite(); })) {
        return &RepairCounts::not_finite_faces;
    }
    return has_zero_area(triangle) ? &RepairCounts::zero_area_faces : nullptr;
}

} // namespace

void drop_bad_faces(Scan& scan, RepairCounts& counts) {
    std::erase_if(scan.faces, [&](const Triangle& face) {
        const Count flaw = flaw_of(scan, face);
        if (flaw != nullptr) {
            ++(counts.*flaw);
        }
        return flaw != nullptr;
    });
}

} // namespace foldless
