#include <foldless/io/edge_table.h>

#include <algorithm>

namespace foldless {

namespace {

/// Calls visit(low, high, face) for the three sides of every face that has three vertices.
template <class Visit>
void for_each_side(std::span<const Triangle> faces, std::size_t vertices, Visit&& visit) {
    for (std::size_t face = 0; face < faces.size(); ++face) {
        if (!has_three_vertices(faces[face], vertices)) {
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(faces[face][i], faces[face][(i + 1) % 3]);
            visit(static_cast<std::size_t>(low), high, static_cast<std::int32_t>(face));
        }
    }
}

} // namespace

bool has_three_vertices(const Triangle& face, std::size_t vertices) {
    const auto in_range = [vertices](std::int32_t index) {
        return index >= 0 && static_cast<std::size_t>(index) < vertices;
    };
    return std::ranges::all_of(face, in_range) && face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

EdgeTable::EdgeTable(std::span<const Triangle> faces, std::size_t vertices) : start_(vertices + 1, 0) {
    // A counting sort by the smaller vertex: first the ends of the buckets, which filling turns into their starts.
    for_each_side(faces, vertices, [&](std::size_t low, std::int32_t, std::int32_t) { ++start_[low]; });
    std::size_t end = 0;
    for (std::size_t& bucket : start_) {
        end += bucket;
        bucket = end;
    }
    entries_.resize(end);
    for_each_side(faces, vertices, [&](std::size_t low, std::int32_t high, std::int32_t face) {
        entries_[--start_[low]] = {high, face};
    });
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(start_[vertex]),
                  entries_.begin() + static_cast<std::ptrdiff_t>(start_[vertex + 1]));
    }
}

} // namespace foldless
