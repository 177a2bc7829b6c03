#include <foldless/models/make_model.h>

#include <foldless/models/patchworks.h>
#include <foldless/models/sheets.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace foldless {

namespace {

/// Three cells are the fewest around a closed direction; open ones are given as many.
constexpr std::int64_t least_cells = 3;

bool is_sheet(Shape shape) {
    return shape == Shape::torus || shape == Shape::knot || shape == Shape::terrain || shape == Shape::fold;
}

Sheet sheet_of(Shape shape) {
    switch (shape) {
    case Shape::knot: return knot();
    case Shape::terrain: return terrain();
    case Shape::fold: return fold();
    default: return torus();
    }
}

Patchwork patchwork_of(Shape shape, std::int64_t n) {
    switch (shape) {
    case Shape::bumpy_sphere: return bumpy_sphere();
    case Shape::genus2: return genus2();
    case Shape::cylinder: return cylinder();
    case Shape::ears: return ears();
    case Shape::spike: return spike();
    case Shape::cube: return cube(n);
    default: return sphere();
    }
}

/// Rows as the aspect asks, and all the columns that the number of faces still allows.
Lattice lattice_of(const Sheet& sheet, std::int64_t faces) {
    const auto square = std::llround(std::floor(std::sqrt(static_cast<double>(faces) / 2 / sheet.aspect)));
    const std::int64_t rows = std::max<std::int64_t>(square, least_cells);
    return {faces / (2 * rows), rows, sheet.wraps_u, sheet.wraps_v};
}

/// Faces of a quilt of n = 1; one of n has n^2 times as many.
std::int64_t faces_of(const std::vector<QuiltPatch>& patches) {
    std::int64_t faces = 0;
    for (const QuiltPatch& patch : patches) {
        faces += 2 * patch.weight_u * patch.weight_v;
    }
    return faces;
}

/// The greatest n with n^2 * unit <= faces.
std::int64_t quilt_size(std::int64_t unit, std::int64_t faces) {
    auto n = std::llround(std::sqrt(static_cast<double>(faces) / static_cast<double>(unit)));
    while (n * n * unit > faces) {
        --n;
    }
    return n;
}

void check(const ModelRequest& request) {
    const std::int64_t least = least_faces(request.shape);
    if (request.faces < least || request.faces > most_faces) {
        throw std::invalid_argument(fmt::format("{} has from {} to {} faces, not {}", name_of(request.shape), least,
                                                most_faces, request.faces));
    }
    if (!(std::isfinite(request.finish.noise) && request.finish.noise >= 0)) {
        throw std::invalid_argument("the noise must be a finite number, 0 or more");
    }
}

} // namespace

std::int64_t least_faces(Shape shape) {
    return is_sheet(shape) ? 2 * least_cells * least_cells : faces_of(patchwork_of(shape, 1).patches);
}

Model make_model(const ModelRequest& request) {
    check(request);
    if (is_sheet(request.shape)) {
        Sheet sheet = sheet_of(request.shape);
        return {lattice_of(sheet, request.faces), std::move(sheet.surface), request.finish};
    }
    const std::int64_t n = quilt_size(least_faces(request.shape), request.faces);
    Patchwork patchwork = patchwork_of(request.shape, n);
    return {Quilt(std::move(patchwork.patches), n), std::move(patchwork.surface), request.finish};
}

std::int32_t spike_vertex() {
    return spike_corner;
}

} // namespace foldless
