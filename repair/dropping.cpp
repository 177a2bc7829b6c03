#include <foldless/repair/dropping.h>

namespace foldless {

std::size_t drop_marked_faces(Scan& scan, const std::vector<std::uint8_t>& marked) {
    std::size_t kept = 0;
    for (std::size_t face = 0; face < scan.faces.size(); ++face) {
        if (marked[face] == 0) {
            scan.faces[kept++] = scan.faces[face];
        }
    }
    const std::size_t dropped = scan.faces.size() - kept;
    scan.faces.resize(kept);
    return dropped;
}

void drop_unused_vertices(Scan& scan, RepairCounts& counts) {
    constexpr std::int32_t unused = -1;
    std::vector<std::int32_t> number(scan.positions.size(), unused);
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t vertex : face) {
            number[vertex] = vertex;
        }
    }
    std::int32_t kept = 0;
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex) {
        if (number[vertex] != unused) {
            scan.positions[kept] = scan.positions[vertex];
            number[vertex] = kept++;
        }
    }
    counts.dropped_vertices += scan.positions.size() - static_cast<std::size_t>(kept);
    scan.positions.resize(kept);
    for (Triangle& face : scan.faces) {
        for (std::int32_t& vertex : face) {
            vertex = number[vertex];
        }
    }
}

} // namespace foldless
