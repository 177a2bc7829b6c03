#include <foldless/decimate/patched_surface.h>

#include <foldless/io/float32.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace foldless {
namespace {

/// An edge over a power of two that makes its largest component 1 to 2, so that no product overflows or vanishes. The
/// quarters keep the difference itself from overflowing.
Vec3 edge(const Vec3& from, const Vec3& to) {
    const Vec3 quarter = 0.25 * to - 0.25 * from;
    const double size = quarter.cwiseAbs().maxCoeff();
    return quarter.unaryExpr([size](double x) { return size > 0 ? std::ldexp(x, -std::ilogb(size)) : x; });
}

} // namespace

Vec3 face_direction(const std::array<Vec3, 3>& corners) {
    const Vec3 normal = edge(corners[0], corners[1]).cross(edge(corners[0], corners[2]));
    return to_float32(normal.normalized());
}

void PatchedSurface::reset(const Patch& patch, bool constant_directions) {
    patch_ = &patch;
    constant_directions_ = constant_directions;
    removed_.clear();
    cell_for_.clear();
    cells_used_ = 0;
    fans_used_ = 0;
    impassable_.clear();
    for (const std::int32_t face : patch.removed) {
        removed_.insert(face);
    }
    find_rim();
    for (const PatchFace& face : patch.added) {
        prepare(-1, face.corners, represents_itself(face));
    }
}

void PatchedSurface::find_rim() {
    rim_.clear();
    for (const std::int32_t face : patch_->removed) {
        const Triangle corners = base_->corners(face);
        for (int k = 0; k < 3; ++k) {
            const std::int32_t outer = base_->neighbour(face, k);
            if (outer >= 0 && !removes(outer)) {
                rim_.push_back({corners[(k + 1) % 3], corners[(k + 2) % 3], outer});
            }
        }
    }
}

BaseVertex PatchedSurface::vertex(std::int32_t v) const {
    for (const PatchVertex& changed : patch_->changed) {
        if (changed.index == v) {
            return changed.value;
        }
    }
    return base_->vertex(v);
}

void PatchedSurface::prepare(std::int32_t face, const Triangle& corners, bool impassable) {
    if (cells_used_ == static_cast<int>(cells_.size())) {
        cells_.push_back(std::make_unique<Cell>());
    }
    Cell& cell = *cells_[cells_used_++];
    cell.walls.fill(std::nullopt);
    cell.face = face;
    cell.corners = corners;
    cell.neighbours.fill(not_yet_known);
    cell.impassable = impassable;
    cell.range = face >= 0 ? base_->face(face).range : Range{0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        const BaseVertex corner = vertex(corners[k]);
        cell.triangle.v[k] = corner.position;
        cell.triangle.d[k] = corner.direction;
        cell.kept[k] = corner.scan_vertex >= 0;
    }
    if (constant_directions_) {
        cell.triangle.d.fill(face_direction(cell.triangle.v));
    }
}

bool PatchedSurface::represents_itself(const PatchFace& face) const {
    // Only a face that has never changed can be its own scan face; it still is while its corners are kept.
    if (face.slot < 0 || !base_->face(face.slot).is_scan_face) {
        return false;
    }
    const Triangle before = base_->corners(face.slot);
    for (const std::int32_t v : face.corners) {
        if (std::find(before.begin(), before.end(), v) == before.end() ||
            vertex(v).scan_vertex != base_->vertex(v).scan_vertex) {
            return false;
        }
    }
    return true;
}

int PatchedSurface::cell_of(std::int32_t face) {
    assert(!removes(face));
    const int known = cell_for_.find(face);
    if (known >= 0) {
        return known;
    }
    const int cell = cells_used_;
    cell_for_.set(face, cell);
    prepare(face, base_->corners(face), base_->face(face).is_scan_face);
    return cell;
}

int PatchedSurface::new_cell_along(std::int32_t from, std::int32_t to) const {
    for (int c = 0; c < new_cells(); ++c) {
        const Triangle& corners = cells_[c]->corners;
        for (int k = 0; k < 3; ++k) {
            if (corners[k] == from && corners[(k + 1) % 3] == to) {
                return c;
            }
        }
    }
    return border;
}

int PatchedSurface::neighbour(int c, int k) {
    if (cells_[c]->neighbours[k] == not_yet_known) {
        const int found = find_neighbour(c, k);
        cells_[c]->neighbours[k] = found; // after the search, which may add cells
    }
    return cells_[c]->neighbours[k];
}

int PatchedSurface::find_neighbour(int c, int k) {
    const std::int32_t from = cells_[c]->corners[(k + 1) % 3];
    const std::int32_t to = cells_[c]->corners[(k + 2) % 3];
    if (cells_[c]->face >= 0) {
        const std::int32_t face = base_->neighbour(cells_[c]->face, k);
        if (face >= 0 && !removes(face)) {
            return cell_of(face);
        }
        return face < 0 ? border : new_cell_along(to, from);
    }
    const auto on_rim = [&](const RimEdge& edge) { return edge.from == from && edge.to == to; };
    const auto edge = std::find_if(rim_.begin(), rim_.end(), on_rim);
    return edge != rim_.end() ? cell_of(edge->outer) : new_cell_along(to, from);
}

int PatchedSurface::corner_of(int c, std::int32_t v) const {
    const Triangle& corners = cells_[c]->corners;
    const auto found = std::find(corners.begin(), corners.end(), v);
    return found == corners.end() ? -1 : static_cast<int>(found - corners.begin());
}

bool PatchedSurface::share_corner(int a, int b) const {
    const Triangle& corners = cells_[b]->corners;
    return corner_of(a, corners[0]) >= 0 || corner_of(a, corners[1]) >= 0 || corner_of(a, corners[2]) >= 0;
}

void PatchedSurface::cells_beside(std::vector<int>& out) {
    out.clear();
    const auto add_around = [&](std::int32_t v) {
        around_.clear();
        base_->append_faces_around(v, around_);
        for (const std::int32_t face : around_) {
            if (removes(face)) {
                continue;
            }
            if (base_->face(face).is_scan_face) {
                impassable_.push_back(face);
            } else {
                out.push_back(cell_of(face));
            }
        }
    };
    // Along a closed rim every vertex starts an edge; an open one ends at one that does not.
    for (const RimEdge& edge : rim_) {
        add_around(edge.from);
        const auto starts_here = [&](const RimEdge& other) { return other.from == edge.to; };
        if (std::none_of(rim_.begin(), rim_.end(), starts_here)) {
            add_around(edge.to);
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
}

void PatchedSurface::append_read(std::vector<std::int32_t>& out) const {
    for (int c = new_cells(); c < cells_used_; ++c) {
        out.push_back(cells_[c]->face);
    }
    out.insert(out.end(), impassable_.begin(), impassable_.end());
}

int PatchedSurface::any_cell_at(std::int32_t v) {
    for (int c = 0; c < new_cells(); ++c) {
        if (corner_of(c, v) >= 0) {
            return c;
        }
    }
    return cell_of(base_->any_face_around(v));
}

const Fan& PatchedSurface::fan(std::int32_t v) {
    for (std::size_t n = 0; n < fans_used_; ++n) {
        if (fans_[n].vertex == v) {
            return fans_[n];
        }
    }
    if (fans_used_ == fans_.size()) {
        fans_.emplace_back();
    }
    Fan& fan = fans_[fans_used_++];
    fan.vertex = v;
    walk_around(fan);
    return fan;
}

void PatchedSurface::walk_around(Fan& fan) {
    fan.cells.clear();
    fan.spokes.clear();
    // Around corner k of a cell, the counter-clockwise neighbour lies across the edge to corner k + 2 (opposite corner
    // k + 1) and the clockwise one across the edge to corner k + 1 (opposite corner k + 2).
    const int start = any_cell_at(fan.vertex);
    int c = start;
    do {
        const int k = corner_of(c, fan.vertex);
        fan.cells.push_back(c);
        fan.spokes.push_back(cells_[c]->corners[(k + 1) % 3]);
        const int next = neighbour(c, (k + 1) % 3);
        if (next == border) {
            fan.spokes.push_back(cells_[c]->corners[(k + 2) % 3]);
        }
        c = next;
    } while (c != border && c != start);
    fan.closed = c == start;
    if (fan.closed) {
        return;
    }
    for (c = neighbour(start, (corner_of(start, fan.vertex) + 2) % 3); c != border;) {
        const int k = corner_of(c, fan.vertex);
        fan.cells.insert(fan.cells.begin(), c);
        fan.spokes.insert(fan.spokes.begin(), cells_[c]->corners[(k + 1) % 3]);
        c = neighbour(c, (k + 2) % 3);
    }
}

} // namespace foldless
