#include <foldless/decimate/base_surface.h>

#include <foldless/io/errors.h>

namespace foldless {
namespace {

using Halfedge = OpenMesh::HalfedgeHandle;

} // namespace

BaseSurface::BaseSurface(const Scan& scan)
    : vertices_(scan.positions.size()), faces_(scan.faces.size()), places_(scan.positions.size()),
      next_on_face_(scan.positions.size(), -1) {
    const std::size_t f_count = scan.faces.size();
    connectivity_.reserve(scan.positions.size(), scan.positions.size() + f_count, f_count);
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        connectivity_.add_vertex({0.0F, 0.0F, 0.0F});
        vertices_[v] = {scan.positions[v], Vec3::Zero(), static_cast<std::int32_t>(v)};
        places_[v].kept = static_cast<std::int32_t>(v);
    }
    for (std::size_t f = 0; f < f_count; ++f) {
        const Triangle& face = scan.faces[f];
        const OpenMesh::VertexHandle corners[] = {OpenMesh::VertexHandle(face[0]), OpenMesh::VertexHandle(face[1]),
                                                  OpenMesh::VertexHandle(face[2])};
        if (!connectivity_.add_face(corners, 3).is_valid()) {
            throw RefusedMesh("the faces do not form a manifold");
        }
        faces_[f].scan_faces.assign(1, static_cast<std::int32_t>(f));
    }
}

Triangle BaseSurface::corners(std::int32_t f) const {
    const Halfedge h = connectivity_.halfedge_handle(OpenMesh::FaceHandle(f));
    const Halfedge next = connectivity_.next_halfedge_handle(h);
    return {connectivity_.to_vertex_handle(h).idx(), connectivity_.to_vertex_handle(next).idx(),
            connectivity_.from_vertex_handle(h).idx()};
}

std::int32_t BaseSurface::neighbour(std::int32_t f, int k) const {
    // corners() = {c0, c1, c2} with h from c2 to c0: opposite c0 lies c1 -> c2 (previous), opposite c1 lies h itself.
    Halfedge h = connectivity_.halfedge_handle(OpenMesh::FaceHandle(f));
    if (k == 0) {
        h = connectivity_.prev_halfedge_handle(h);
    } else if (k == 2) {
        h = connectivity_.next_halfedge_handle(h);
    }
    return connectivity_.opposite_face_handle(h).idx();
}

void BaseSurface::append_faces_around(std::int32_t v, std::vector<std::int32_t>& out) const {
    const Halfedge outgoing = connectivity_.halfedge_handle(OpenMesh::VertexHandle(v));
    if (!outgoing.is_valid()) {
        return;
    }
    // OpenMesh lets the outgoing halfedge of a border vertex be the border's: the fan then starts behind it.
    const auto turned = [&](Halfedge h) {
        return connectivity_.opposite_halfedge_handle(connectivity_.prev_halfedge_handle(h));
    };
    Halfedge h = connectivity_.is_boundary(outgoing) ? turned(outgoing) : outgoing;
    do {
        out.push_back(connectivity_.face_handle(h).idx());
        h = turned(h);
    } while (h != outgoing);
}

std::int32_t BaseSurface::any_face_around(std::int32_t v) const {
    const Halfedge outgoing = connectivity_.halfedge_handle(OpenMesh::VertexHandle(v));
    const bool at_border = connectivity_.is_boundary(outgoing);
    return (at_border ? connectivity_.opposite_face_handle(connectivity_.prev_halfedge_handle(outgoing))
                      : connectivity_.face_handle(outgoing))
        .idx();
}

void BaseSurface::set_place(std::int32_t scan_vertex, std::int32_t face, const Vec3& alpha, double t) {
    places_[scan_vertex] = {face, -1, alpha, t};
    next_on_face_[scan_vertex] = faces_[face].first_vertex;
    faces_[face].first_vertex = scan_vertex;
}

bool BaseSurface::is_border_vertex(std::int32_t v) const {
    return connectivity_.is_boundary(OpenMesh::VertexHandle(v));
}

} // namespace foldless
