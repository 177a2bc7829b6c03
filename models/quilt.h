/// \file
/// Quadrilateral patches sewn together along whole edges: the connectivity of everything that is not one lattice.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/models/place.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// A patch of n * weight_u by n * weight_v cells, n being common to the whole quilt.
///
///     corners[3]---corners[2]      v
///         |            |           ^
///     corners[0]---corners[1]      +-> u
struct QuiltPatch {
    std::array<int, 4> corners;
    int weight_u = 1;
    int weight_v = 1;
};

/// Patches that share corners, and edges by naming the same two corners. Vertices are numbered corners first, under the
/// numbers that the patches use at any n, then edge by edge, then patch by patch; faces patch by patch, each cell cut
/// from its lower left to its upper right. Any vertex or face costs O(log patches).
class Quilt {
public:
    /// Two corners have at most one edge in common, and the patches at an edge agree on its weight.
    Quilt(std::vector<QuiltPatch> patches, std::int64_t n);

    [[nodiscard]] std::int64_t vertices() const { return interior_offsets_.back(); }
    [[nodiscard]] std::int64_t faces() const { return face_offsets_.back(); }
    [[nodiscard]] CellSize cell_size(int patch) const;
    [[nodiscard]] SurfacePlace place(std::int64_t vertex) const;
    [[nodiscard]] Triangle triangle(std::int64_t face) const;

private:
    /// A side of a patch: 0 from corner 0 to 1, 1 from 1 to 2, 2 from 3 to 2, 3 from 0 to 3, so that u or v grows
    /// along.
    struct Side {
        int patch;
        int side;
    };

    [[nodiscard]] std::int64_t cells_u(int patch) const { return n_ * patches_[patch].weight_u; }
    [[nodiscard]] std::int64_t cells_v(int patch) const { return n_ * patches_[patch].weight_v; }
    [[nodiscard]] std::array<int, 2> ends(Side side) const;
    [[nodiscard]] std::int64_t cells_along(Side side) const;
    [[nodiscard]] SurfacePlace place_on(Side side, double along) const;
    [[nodiscard]] SurfacePlace edge_place(std::int64_t vertex) const;
    [[nodiscard]] SurfacePlace interior_place(std::int64_t vertex) const;
    [[nodiscard]] std::int64_t vertex_on(Side side, std::int64_t step) const;
    [[nodiscard]] std::int32_t vertex_at(int patch, std::int64_t i, std::int64_t j) const;
    void sew();
    void own_corner(int corner, Side side);
    void number();

    std::vector<QuiltPatch> patches_;
    std::int64_t n_;
    std::vector<Side> corner_owners_;                  ///< a side that begins or ends at the corner
    std::vector<Side> edge_owners_;                    ///< the first side along the edge; its direction is the edge's
    std::vector<std::array<std::size_t, 4>> edges_of_; ///< of each patch, by side
    std::vector<std::int64_t> edge_offsets_;           ///< first vertex of each edge, and the end
    std::vector<std::int64_t> interior_offsets_;       ///< first inner vertex of each patch, and the end
    std::vector<std::int64_t> face_offsets_;           ///< first face of each patch, and the end
};

} // namespace foldless
