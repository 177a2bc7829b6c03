#include <foldless/io/weld.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace foldless {

namespace {

/// The bits of a position, equal for equal positions and totally ordered even where there are NaNs.
using Key = std::array<std::uint64_t, 3>;

std::uint64_t key(double coordinate) {
    return std::bit_cast<std::uint64_t>(coordinate == 0.0 ? 0.0 : coordinate);
}

struct Entry {
    Key key;
    std::int32_t corner;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 that the compiler compares with for one
    auto operator<=>(const Entry&) const = default;
};

std::vector<Entry> sorted_entries(std::span<const Vec3> corners) {
    std::vector<Entry> entries;
    entries.reserve(corners.size());
    for (const Vec3& corner : corners) {
        entries.push_back(
            {{key(corner.x()), key(corner.y()), key(corner.z())}, static_cast<std::int32_t>(entries.size())});
    }
    std::ranges::sort(entries);
    return entries;
}

/// For each corner the first one at its position.
std::vector<std::int32_t> first_corners(std::span<const Vec3> corners) {
    const std::vector<Entry> entries = sorted_entries(corners);
    std::vector<std::int32_t> first(corners.size());
    std::size_t start = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        start = entries[i].key == entries[start].key ? start : i;
        first[static_cast<std::size_t>(entries[i].corner)] = entries[start].corner;
    }
    return first;
}

} // namespace

Welded weld(std::span<const Vec3> corners) {
    Welded welded{{}, first_corners(corners)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // The first corner of a position comes before all others, so its entry has been replaced by the index already.
        const auto first = static_cast<std::size_t>(welded.indices[i]);
        if (first == i) {
            welded.indices[i] = static_cast<std::int32_t>(welded.positions.size());
            welded.positions.push_back(corners[i]);
        } else {
            welded.indices[i] = welded.indices[first];
        }
    }
    return welded;
}

} // namespace foldless
