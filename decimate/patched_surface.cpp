#include <foldless/decimate/patched_surface.h>

#include <foldless/io/float32.h>

#include <algorithm>
#include <cassert>

namespace foldless {

Vec3 face_direction(const std::array<Vec3, 3>& corners) {
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    return to_float32(normal.normalized());
}

PatchedSurface::PatchedSurface(const BaseSurface& base)
    : base_(&base), removed_stamp_(base.face_slots(), 0), cell_stamp_(base.face_slots(), 0),
      cell_index_(base.face_slots(), 0) {}

void PatchedSurface::reset(const Patch& patch, bool constant_directions) {
    patch_ = &patch;
    constant_directions_ = constant_directions;
    ++stamp_;
    cells_.clear();
    for (const std::int32_t face : patch.removed) {
        removed_stamp_[face] = stamp_;
    }
    for (const PatchFace& face : patch.added) {
        cells_.push_back(prepare(-1, face.corners, represents_itself(face)));
    }
}

const BaseVertex& PatchedSurface::vertex(std::int32_t v) const {
    for (const PatchVertex& changed : patch_->changed) {
        if (changed.index == v) {
            return changed.value;
        }
    }
    return base_->vertex(v);
}

Cell PatchedSurface::prepare(std::int32_t face, const Triangle& corners, bool impassable) const {
    BaseTriangle triangle;
    std::array<bool, 3> kept{};
    for (int k = 0; k < 3; ++k) {
        const BaseVertex& corner = vertex(corners[k]);
        triangle.v[k] = corner.position;
        triangle.d[k] = corner.direction;
        kept[k] = corner.scan_vertex >= 0;
    }
    if (constant_directions_) {
        triangle.d.fill(face_direction(triangle.v));
    }
    return {face,
            corners,
            kept,
            {not_yet_known, not_yet_known, not_yet_known},
            triangle,
            {Wall(triangle, 0), Wall(triangle, 1), Wall(triangle, 2)},
            face >= 0 ? base_->face(face).range : Range{0.0, 0.0},
            impassable};
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
    if (cell_stamp_[face] != stamp_) {
        cell_stamp_[face] = stamp_;
        cell_index_[face] = static_cast<int>(cells_.size());
        cells_.push_back(prepare(face, base_->corners(face), base_->face(face).is_scan_face));
    }
    return cell_index_[face];
}

int PatchedSurface::across(std::int32_t from, std::int32_t to) const {
    for (int c = 0; c < new_cells(); ++c) {
        const Triangle& corners = cells_[c].corners;
        for (int k = 0; k < 3; ++k) {
            if (corners[k] == from && corners[(k + 1) % 3] == to) {
                return c;
            }
        }
    }
    return border;
}

int PatchedSurface::neighbour(int c, int k) {
    if (cells_[c].neighbours[k] != not_yet_known) {
        return cells_[c].neighbours[k];
    }
    const std::int32_t from = cells_[c].corners[(k + 1) % 3];
    const std::int32_t to = cells_[c].corners[(k + 2) % 3];
    int result = across(to, from);
    if (result == border) {
        // No new face has this edge: its other face, if any, stays.
        const OpenMesh::HalfedgeHandle edge =
            base_->connectivity().find_halfedge(OpenMesh::VertexHandle(to), OpenMesh::VertexHandle(from));
        const std::int32_t face = edge.is_valid() ? base_->connectivity().face_handle(edge).idx() : -1;
        result = face < 0 || removes(face) ? border : cell_of(face);
    }
    cells_[c].neighbours[k] = result;
    return result;
}

int PatchedSurface::corner_of(int c, std::int32_t v) const {
    const Triangle& corners = cells_[c].corners;
    const auto found = std::find(corners.begin(), corners.end(), v);
    return found == corners.end() ? -1 : static_cast<int>(found - corners.begin());
}

bool PatchedSurface::share_corner(int a, int b) const {
    const Triangle& corners = cells_[b].corners;
    return corner_of(a, corners[0]) >= 0 || corner_of(a, corners[1]) >= 0 || corner_of(a, corners[2]) >= 0;
}

void PatchedSurface::cells_beside(std::vector<int>& out) {
    out.clear();
    std::vector<std::int32_t> rim;
    for (const PatchFace& face : patch_->added) {
        rim.insert(rim.end(), face.corners.begin(), face.corners.end());
    }
    std::sort(rim.begin(), rim.end());
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    for (const std::int32_t v : rim) {
        if (v >= static_cast<std::int32_t>(base_->vertex_slots())) {
            continue; // a vertex that the patch brings
        }
        base_->faces_around(v, around_);
        for (const std::int32_t face : around_) {
            if (!removes(face) && !base_->face(face).is_scan_face) {
                out.push_back(cell_of(face));
            }
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
}

int PatchedSurface::any_cell_at(std::int32_t v) {
    for (int c = 0; c < new_cells(); ++c) {
        if (corner_of(c, v) >= 0) {
            return c;
        }
    }
    base_->faces_around(v, around_);
    return cell_of(around_.front());
}

void PatchedSurface::fan(std::int32_t v, Fan& out) {
    out.cells.clear();
    out.spokes.clear();
    // Around corner k of a cell, the clockwise neighbour lies across the edge to corner k + 1 (opposite corner k + 2)
    // and the counter-clockwise one across the edge to corner k + 2 (opposite corner k + 1).
    const int start = any_cell_at(v);
    int first = start;
    out.closed = false;
    for (int c = start; c != border;) {
        first = c;
        c = neighbour(c, (corner_of(c, v) + 2) % 3);
        if (c == start) {
            out.closed = true;
            first = start;
            break;
        }
    }
    int c = first;
    do {
        const int k = corner_of(c, v);
        out.cells.push_back(c);
        out.spokes.push_back(cells_[c].corners[(k + 1) % 3]);
        const int next = neighbour(c, (k + 1) % 3);
        if (next == border) {
            out.spokes.push_back(cells_[c].corners[(k + 2) % 3]);
        }
        c = next;
    } while (c != border && c != first);
}

} // namespace foldless
