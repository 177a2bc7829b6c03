#include <foldless/models/quilt.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace foldless {

namespace {

constexpr int sides_of_patch = 4;

/// The part that holds an index, given the first index of each part and the end. Empty parts hold nothing.
int part_of(const std::vector<std::int64_t>& offsets, std::int64_t index) {
    return static_cast<int>(std::upper_bound(offsets.begin(), offsets.end(), index) - offsets.begin()) - 1;
}

} // namespace

Quilt::Quilt(std::vector<QuiltPatch> patches, std::int64_t n) : patches_(std::move(patches)), n_(n) {
    sew();
    number();
}

std::array<int, 2> Quilt::ends(Side side) const {
    static constexpr std::array<std::array<int, 2>, sides_of_patch> corners = {{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
    const auto [from, to] = corners[side.side];
    return {patches_[side.patch].corners[from], patches_[side.patch].corners[to]};
}

std::int64_t Quilt::cells_along(Side side) const {
    return side.side % 2 == 0 ? cells_u(side.patch) : cells_v(side.patch);
}

/// Finds the edges, each by its pair of corners, and gives every edge and corner the first side that has it.
void Quilt::sew() {
    std::map<std::pair<int, int>, std::size_t> edges;
    for (int patch = 0; patch < static_cast<int>(patches_.size()); ++patch) {
        std::array<std::size_t, sides_of_patch> of_patch{};
        for (int s = 0; s < sides_of_patch; ++s) {
            const Side side{patch, s};
            const auto [from, to] = ends(side);
            const auto [edge, is_new] = edges.try_emplace(std::minmax(from, to), edges.size());
            if (is_new) {
                edge_owners_.push_back(side);
            }
            assert(cells_along(side) == cells_along(edge_owners_[edge->second]));
            of_patch[s] = edge->second;
            own_corner(from, side);
            own_corner(to, side);
        }
        edges_of_.push_back(of_patch);
    }
}

void Quilt::own_corner(int corner, Side side) {
    const std::size_t count = static_cast<std::size_t>(corner) + 1;
    if (corner_owners_.size() < count) {
        corner_owners_.resize(count, {-1, 0});
    }
    if (corner_owners_[corner].patch < 0) {
        corner_owners_[corner] = side;
    }
}

void Quilt::number() {
    auto vertex = static_cast<std::int64_t>(corner_owners_.size());
    for (const Side& owner : edge_owners_) {
        edge_offsets_.push_back(vertex);
        vertex += cells_along(owner) - 1;
    }
    edge_offsets_.push_back(vertex);
    std::int64_t face = 0;
    for (int patch = 0; patch < static_cast<int>(patches_.size()); ++patch) {
        interior_offsets_.push_back(vertex);
        face_offsets_.push_back(face);
        vertex += (cells_u(patch) - 1) * (cells_v(patch) - 1);
        face += 2 * cells_u(patch) * cells_v(patch);
    }
    interior_offsets_.push_back(vertex);
    face_offsets_.push_back(face);
}

CellSize Quilt::cell_size(int patch) const {
    return {1.0 / static_cast<double>(cells_u(patch)), 1.0 / static_cast<double>(cells_v(patch))};
}

SurfacePlace Quilt::place_on(Side side, double along) const {
    switch (side.side) {
    case 0: return {side.patch, along, 0};
    case 1: return {side.patch, 1, along};
    case 2: return {side.patch, along, 1};
    default: return {side.patch, 0, along};
    }
}

SurfacePlace Quilt::edge_place(std::int64_t vertex) const {
    const int edge = part_of(edge_offsets_, vertex);
    const Side owner = edge_owners_[edge];
    const std::int64_t step = vertex - edge_offsets_[edge] + 1;
    return place_on(owner, static_cast<double>(step) / static_cast<double>(cells_along(owner)));
}

SurfacePlace Quilt::interior_place(std::int64_t vertex) const {
    const int patch = part_of(interior_offsets_, vertex);
    const std::int64_t index = vertex - interior_offsets_[patch];
    const std::int64_t width = cells_u(patch) - 1;
    const std::int64_t i = index % width + 1;
    const std::int64_t j = index / width + 1;
    return {patch, static_cast<double>(i) / static_cast<double>(cells_u(patch)),
            static_cast<double>(j) / static_cast<double>(cells_v(patch))};
}

SurfacePlace Quilt::place(std::int64_t vertex) const {
    if (vertex < edge_offsets_.front()) {
        const Side owner = corner_owners_[static_cast<std::size_t>(vertex)];
        return place_on(owner, ends(owner)[0] == vertex ? 0.0 : 1.0);
    }
    return vertex < interior_offsets_.front() ? edge_place(vertex) : interior_place(vertex);
}

/// The vertex at 0 <= step <= cells_along(side) of a side, which may run against its edge.
std::int64_t Quilt::vertex_on(Side side, std::int64_t step) const {
    const auto [from, to] = ends(side);
    const std::int64_t cells = cells_along(side);
    if (step == 0) {
        return from;
    }
    if (step == cells) {
        return to;
    }
    const std::size_t edge = edges_of_[side.patch][side.side];
    const bool along_edge = ends(edge_owners_[edge])[0] == from;
    return edge_offsets_[edge] + (along_edge ? step : cells - step) - 1;
}

std::int32_t Quilt::vertex_at(int patch, std::int64_t i, std::int64_t j) const {
    std::int64_t vertex = 0;
    if (j == 0) {
        vertex = vertex_on({patch, 0}, i);
    } else if (j == cells_v(patch)) {
        vertex = vertex_on({patch, 2}, i);
    } else if (i == 0) {
        vertex = vertex_on({patch, 3}, j);
    } else if (i == cells_u(patch)) {
        vertex = vertex_on({patch, 1}, j);
    } else {
        vertex = interior_offsets_[patch] + (j - 1) * (cells_u(patch) - 1) + i - 1;
    }
    return static_cast<std::int32_t>(vertex);
}

Triangle Quilt::triangle(std::int64_t face) const {
    const int patch = part_of(face_offsets_, face);
    const std::int64_t cell = (face - face_offsets_[patch]) / 2;
    const std::int64_t i = cell % cells_u(patch);
    const std::int64_t j = cell / cells_u(patch);
    if (face % 2 == 0) {
        return {vertex_at(patch, i, j), vertex_at(patch, i + 1, j), vertex_at(patch, i + 1, j + 1)};
    }
    return {vertex_at(patch, i, j), vertex_at(patch, i + 1, j + 1), vertex_at(patch, i, j + 1)};
}

} // namespace foldless
