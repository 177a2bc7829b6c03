#include <foldless/decimate/collapse.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

Collapse along(const BaseSurface& base, OpenMesh::HalfedgeHandle halfedge) {
    return {halfedge, base.connectivity().from_vertex_handle(halfedge).idx(),
            base.connectivity().to_vertex_handle(halfedge).idx()};
}

Vec3 normal_of(const std::array<Vec3, 3>& corners) {
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

BaseVertex vertex_of(const BaseSurface& base, const Patch& patch, std::int32_t v) {
    for (const PatchVertex& changed : patch.changed) {
        if (changed.index == v) {
            return changed.value;
        }
    }
    return base.vertex(v);
}

int valence(const BaseSurface& base, std::int32_t v) {
    return static_cast<int>(base.connectivity().valence(OpenMesh::VertexHandle(v)));
}

bool is_beside_crowded_vertex(const BaseSurface& base, const Collapse& collapse) {
    std::vector<std::int32_t> rim;
    rim_of(base, collapse, rim);
    return std::any_of(rim.begin(), rim.end(),
                       [&](std::int32_t v) { return valence(base, v) > most_edges_at_a_vertex; });
}

/// The vertex across a halfedge in its face, invalid at a border. False if the other two edges of that face are border
/// edges: the face would be left as one edge.
bool find_apex(const Connectivity& mesh, OpenMesh::HalfedgeHandle halfedge, OpenMesh::VertexHandle& apex) {
    if (mesh.is_boundary(halfedge)) {
        return true;
    }
    const OpenMesh::HalfedgeHandle next = mesh.next_halfedge_handle(halfedge);
    apex = mesh.to_vertex_handle(next);
    return !mesh.is_boundary(mesh.opposite_halfedge_handle(next)) ||
           !mesh.is_boundary(mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(next)));
}

/// Whether the ends have no neighbour in common but the apexes of the faces at the edge. OpenMesh's is_collapse_ok()
/// asks the same, but marks vertices while it does, which threads must not.
bool meets_link_condition(const Connectivity& mesh, OpenMesh::HalfedgeHandle halfedge) {
    OpenMesh::VertexHandle left;
    OpenMesh::VertexHandle right;
    if (!find_apex(mesh, halfedge, left) || !find_apex(mesh, mesh.opposite_halfedge_handle(halfedge), right) ||
        left == right) {
        return false;
    }
    const OpenMesh::VertexHandle stays = mesh.to_vertex_handle(halfedge);
    for (const auto a : mesh.vv_range(mesh.from_vertex_handle(halfedge))) {
        for (const auto b : mesh.vv_range(stays)) {
            if (a == b && a != left && a != right) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

Collapse reversed(const BaseSurface& base, const Collapse& collapse) {
    return along(base, base.connectivity().opposite_halfedge_handle(collapse.halfedge));
}

Verdict make_collapse(const BaseSurface& base, std::int32_t edge, const CollapseRules& rules, Collapse& out) {
    const std::span<const Mobility> mobility = rules.mobility;
    const Connectivity& mesh = base.connectivity();
    const OpenMesh::EdgeHandle handle(edge);
    out = along(base, mesh.halfedge_handle(handle, 0));
    if (mobility[out.gone] == Mobility::fixed && mobility[out.stays] == Mobility::fixed) {
        return mesh.is_boundary(handle) ? Verdict::boundary : Verdict::frozen;
    }
    const bool border_gone = base.is_border_vertex(out.gone);
    const bool border_stays = base.is_border_vertex(out.stays);
    if (border_gone && border_stays && !mesh.is_boundary(handle)) {
        return Verdict::boundary; // would pinch two parts of the border together
    }
    if (mobility[out.gone] == Mobility::fixed || (border_gone && !border_stays)) {
        out = reversed(base, out);
    }
    if (valence(base, out.gone) + valence(base, out.stays) - 1 >= rules.edge_valence_limit ||
        (rules.has_crowded_vertices && is_beside_crowded_vertex(base, out))) {
        return Verdict::valence;
    }
    // A closed component of four faces would become two faces on the same corners, which OpenMesh does not see.
    const bool tetrahedron =
        !border_gone && !border_stays && valence(base, out.gone) == 3 && valence(base, out.stays) == 3;
    return !tetrahedron && meets_link_condition(mesh, out.halfedge) ? Verdict::accepted : Verdict::link_condition;
}

void fill_faces(const BaseSurface& base, const Collapse& collapse, Extent extent, Patch& patch) {
    patch.clear();
    const auto take = [&](std::int32_t v) { base.append_faces_around(v, patch.removed); };
    take(collapse.gone);
    if (extent != Extent::star_of_gone) {
        take(collapse.stays);
    }
    if (extent == Extent::two_rings) {
        std::vector<std::int32_t> rim;
        rim_of(base, collapse, rim);
        std::for_each(rim.begin(), rim.end(), take);
    }
    std::sort(patch.removed.begin(), patch.removed.end());
    patch.removed.erase(std::unique(patch.removed.begin(), patch.removed.end()), patch.removed.end());
    for (const std::int32_t f : patch.removed) {
        Triangle corners = base.corners(f);
        const bool has_gone = std::find(corners.begin(), corners.end(), collapse.gone) != corners.end();
        const bool has_stays = std::find(corners.begin(), corners.end(), collapse.stays) != corners.end();
        if (has_gone && has_stays) {
            continue;
        }
        std::replace(corners.begin(), corners.end(), collapse.gone, collapse.stays);
        patch.added.push_back({corners, f});
    }
}

void rim_of(const BaseSurface& base, const Collapse& collapse, std::vector<std::int32_t>& out) {
    out.clear();
    for (const std::int32_t end : {collapse.gone, collapse.stays}) {
        for (const auto v : base.connectivity().vv_range(OpenMesh::VertexHandle(end))) {
            out.push_back(v.idx());
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    std::erase_if(out, [&](std::int32_t v) { return v == collapse.gone || v == collapse.stays; });
}

Verdict guard_faces(const BaseSurface& base, const Patch& patch) {
    for (const PatchFace& face : patch.added) {
        std::array<Vec3, 3> after;
        std::array<Vec3, 3> before;
        const Triangle old = base.corners(face.slot);
        for (int k = 0; k < 3; ++k) {
            after[k] = vertex_of(base, patch, face.corners[k]).position;
            before[k] = base.vertex(old[k]).position;
        }
        const Vec3 normal = normal_of(after);
        if (!(normal.squaredNorm() > 0) || !std::isfinite(normal.squaredNorm())) {
            return Verdict::degenerate;
        }
        if (!(normal.dot(normal_of(before)) > 0)) {
            return Verdict::flip;
        }
    }
    return Verdict::accepted;
}

} // namespace foldless
