/// \file
/// A rectangle of cells that may be closed in either direction: the connectivity of a sheet, a tube or a torus.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/models/place.h>

#include <cstdint>

namespace foldless {

/// Rows of quadrilateral cells, each cut into two triangles. A direction that wraps needs at least three cells, or the
/// mesh is no simplicial complex.
///
///     d---c      v
///     | / |      ^      cell (i, j) has the triangles a b c and a c d;
///     a---b      +-> u  vertex (i, j) has the index j * columns + i
struct Lattice {
    std::int64_t cells_u;
    std::int64_t cells_v;
    bool wraps_u;
    bool wraps_v;

    [[nodiscard]] std::int64_t columns() const { return cells_u + (wraps_u ? 0 : 1); }
    [[nodiscard]] std::int64_t rows() const { return cells_v + (wraps_v ? 0 : 1); }
    [[nodiscard]] std::int64_t vertices() const { return columns() * rows(); }
    [[nodiscard]] std::int64_t faces() const { return 2 * cells_u * cells_v; }
    [[nodiscard]] CellSize cell_size(int patch) const;
    [[nodiscard]] SurfacePlace place(std::int64_t vertex) const;
    [[nodiscard]] Triangle triangle(std::int64_t face) const;
};

} // namespace foldless
