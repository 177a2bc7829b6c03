#include <foldless/repair/duplicate_faces.h>

#include <foldless/repair/dropping.h>

#include <algorithm>
#include <cstddef>

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

std::vector<std::uint8_t> drop_duplicate_faces(Scan& scan, RepairCounts& counts) {
    const std::vector<NumberedFace> sorted = sorted_faces(scan);
    std::vector<std::uint8_t> duplicate(scan.faces.size(), 0);
    std::vector<std::uint8_t> doubled(scan.faces.size(), 0);
    std::size_t first = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].vertices == sorted[first].vertices) {
            duplicate[sorted[i].face] = 1;
            doubled[sorted[first].face] ^= 1U;
        } else {
            first = i;
        }
    }
    std::size_t kept = 0;
    for (std::size_t face = 0; face < doubled.size(); ++face) {
        if (duplicate[face] == 0) {
            doubled[kept++] = doubled[face];
        }
    }
    doubled.resize(kept);
    counts.duplicate_faces += drop_marked_faces(scan, duplicate);
    return doubled;
}

} // namespace foldless
