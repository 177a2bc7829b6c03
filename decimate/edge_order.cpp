#include <foldless/decimate/edge_order.h>

namespace foldless {
namespace {

double squared_length(const BaseSurface& base, std::int32_t edge) {
    const Connectivity& mesh = base.connectivity();
    const auto h = mesh.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
    return (base.vertex(mesh.to_vertex_handle(h).idx()).position -
            base.vertex(mesh.from_vertex_handle(h).idx()).position)
        .squaredNorm();
}

} // namespace

EdgeQueue all_edges(const BaseSurface& base) {
    EdgeQueue queue(base.connectivity().n_edges(), [&base](std::int32_t edge) { return squared_length(base, edge); });
    queue.push_all();
    return queue;
}

void edges_changed_by(const BaseSurface& base, const Collapse& collapse, Extent extent,
                      std::vector<std::int32_t>& edges) {
    edges.clear();
    const auto add_around = [&](std::int32_t v) {
        for (const auto edge : base.connectivity().ve_range(OpenMesh::VertexHandle(v))) {
            edges.push_back(edge.idx());
        }
    };
    add_around(collapse.gone);
    if (extent != Extent::star_of_gone) {
        add_around(collapse.stays);
    }
}

void requeue(const BaseSurface& base, std::int32_t stays, const std::vector<std::int32_t>& changed, EdgeQueue& queue) {
    const Connectivity& mesh = base.connectivity();
    for (const std::int32_t edge : changed) {
        if (mesh.status(OpenMesh::EdgeHandle(edge)).deleted()) {
            queue.erase(edge);
        } else {
            queue.push(edge);
        }
    }
    for (const auto neighbour : mesh.vv_range(OpenMesh::VertexHandle(stays))) {
        for (const auto edge : mesh.ve_range(neighbour)) {
            queue.wake(edge.idx());
        }
    }
}

} // namespace foldless
