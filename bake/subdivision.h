/// \file
/// The vertices and faces of a mesh whose faces are cut into 4^level each.
#pragma once

#include <foldless/io/scan.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// Numbers the vertices: those of the mesh, then those on its edges, then those inside its faces. A vertex of a face is
/// given by its weights (a, b, c), integers with the sum 2^level.
class Subdivision {
public:
    /// Time O(f log f).
    Subdivision(std::size_t vertices, const std::vector<Triangle>& faces, int level);

    [[nodiscard]] int segments() const { return segments_; }
    [[nodiscard]] std::size_t vertex_count() const;
    [[nodiscard]] std::size_t faces_per_face() const {
        return static_cast<std::size_t>(segments_) * static_cast<std::size_t>(segments_);
    }

    using Weights = std::array<int, 3>;

    [[nodiscard]] std::size_t vertex(std::int32_t face, const Weights& weights) const;

    /// Calls visit(weights, weights, weights) for the corners of each small face, in the orientation of the face.
    template <class Visit>
    void for_each_face(Visit visit) const;

private:
    [[nodiscard]] std::size_t on_edge(std::int32_t face, int opposite, const Weights& weights) const;

    std::size_t vertices_;
    const std::vector<Triangle>& faces_;
    int segments_;
    std::size_t edge_count_ = 0;
    std::vector<std::array<std::int32_t, 3>> edges_; ///< of each face: the number of the edge opposite each corner
};

template <class Visit>
void Subdivision::for_each_face(Visit visit) const {
    for (int c = 0; c < segments_; ++c) {
        for (int b = 0; b + c < segments_; ++b) {
            const int a = segments_ - b - c;
            visit(Weights{a, b, c}, Weights{a - 1, b + 1, c}, Weights{a - 1, b, c + 1});
            if (a > 1) {
                visit(Weights{a - 1, b + 1, c}, Weights{a - 2, b + 1, c + 1}, Weights{a - 1, b, c + 1});
            }
        }
    }
}

} // namespace foldless
