#include <foldless/repair/small_components.h>

#include <foldless/io/union_find.h>
#include <foldless/repair/dropping.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foldless {

void drop_small_components(Scan& scan, std::size_t least, RepairCounts& counts) {
    UnionFind components(scan.positions.size());
    const auto number = [](std::int32_t vertex) { return static_cast<std::uint32_t>(vertex); };
    for (const Triangle& face : scan.faces) {
        components.join(number(face[0]), number(face[1]));
        components.join(number(face[0]), number(face[2]));
    }
    std::vector<std::size_t> faces(scan.positions.size(), 0);
    for (const Triangle& face : scan.faces) {
        ++faces[components.find(number(face[0]))];
    }
    std::vector<std::uint8_t> small;
    small.reserve(scan.faces.size());
    for (const Triangle& face : scan.faces) {
        small.push_back(faces[components.find(number(face[0]))] < least ? 1 : 0);
    }
    counts.small_components += static_cast<std::size_t>(
        std::ranges::count_if(faces, [least](std::size_t count) { return count > 0 && count < least; }));
    counts.small_component_faces += drop_marked_faces(scan, small);
}

} // namespace foldless
