#include <foldless/repair/duplicate_faces.h>

#include <foldless/repair/dropping.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foldless {

namespace {

struct NumberedFace {
    Triangle vertices; ///< in ascending order
    std::int32_t face;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 that the compiler compares with for one
    auto operator<=>(const NumberedFace&) const = default;
};

/// Faces of the same vertices stand side by side, the first of them first.
std::vector<NumberedFace> sorted_faces(const Scan& scan) {
    std::vector<NumberedFace> sorted;
    sorted.reserve(scan.faces.size());
    for (const Triangle& face : scan.faces) {
        sorted.push_back({face, static_cast<std::int32_t>(sorted.size())});
        std::ranges::sort(sorted.back().vertices);
    }
    std::ranges::sort(sorted);
    return sorted;
}

} // namespace

void drop_duplicate_faces(Scan& scan, RepairCounts& counts) {
    const std::vector<NumberedFace> sorted = sorted_faces(scan);
    std::vector<std::uint8_t> duplicate(scan.faces.size(), 0);
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        duplicate[sorted[i].face] = sorted[i].vertices == sorted[i - 1].vertices ? 1 : 0;
    }
    counts.duplicate_faces += drop_marked_faces(scan, duplicate);
}

} // namespace foldless
