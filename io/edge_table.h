/// \file
/// The edges of a triangle mesh, each with all its faces, from nothing but the list of faces.
#pragma once

#include <foldless/io/scan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// Whether a face names three different vertices of the mesh.
[[nodiscard]] bool has_three_vertices(const Triangle& face, std::size_t vertices);

/// The faces of every edge. Faces without three different vertices of the mesh have no edges. Memory: 8 bytes for each
/// of the three sides of a face, and 8 for each vertex.
class EdgeTable {
public:
    /// A face at an edge.
    struct Entry {
        std::int32_t other; ///< the larger vertex of the edge
        std::int32_t face;
        // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 that the compiler compares with for one
        auto operator<=>(const Entry&) const = default;
    };

    /// Time O(n log n): the sides are sorted vertex by vertex.
    EdgeTable(std::span<const Triangle> faces, std::size_t vertices);

    /// Calls visit(a, b, entries) for every edge, with a < b, in ascending order of (a, b); the entries hold its faces
    /// in ascending order.
    template <class Visit>
    void for_each_edge(Visit&& visit) const {
        for (std::size_t vertex = 0; vertex + 1 < start_.size(); ++vertex) {
            const std::span<const Entry> all(entries_.data() + start_[vertex], start_[vertex + 1] - start_[vertex]);
            for (std::size_t first = 0; first < all.size();) {
                std::size_t last = first + 1;
                while (last < all.size() && all[last].other == all[first].other) {
                    ++last;
                }
                visit(static_cast<std::int32_t>(vertex), all[first].other, all.subspan(first, last - first));
                first = last;
            }
        }
    }

private:
    std::vector<std::size_t> start_; ///< where the entries of each vertex begin; one more for the end
    std::vector<Entry> entries_;
};

} // namespace foldless
