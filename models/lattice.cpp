#include <foldless/models/lattice.h>

namespace foldless {

CellSize Lattice::cell_size(int /*patch*/) const {
    return {1.0 / static_cast<double>(cells_u), 1.0 / static_cast<double>(cells_v)};
}

SurfacePlace Lattice::place(std::int64_t vertex) const {
    const std::int64_t i = vertex % columns();
    const std::int64_t j = vertex / columns();
    return {0, static_cast<double>(i) / static_cast<double>(cells_u),
            static_cast<double>(j) / static_cast<double>(cells_v)};
}

Triangle Lattice::triangle(std::int64_t face) const {
    const std::int64_t cell = face / 2;
    const std::int64_t i = cell % cells_u;
    const std::int64_t j = cell / cells_u;
    const auto vertex = [&](std::int64_t column, std::int64_t row) {
        return static_cast<std::int32_t>((row % rows()) * columns() + column % columns());
    };
    if (face % 2 == 0) {
        return {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)};
    }
    return {vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
}

} // namespace foldless
