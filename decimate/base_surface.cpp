#include <foldless/decimate/base_surface.h>

#include <foldless/io/errors.h>
#include <foldless/io/float32.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace foldless {
namespace {

using Halfedge = OpenMesh::HalfedgeHandle;

/// Room for the lists of scan faces, in numbers per face of the scan. On scans at most 2.4 numbers are in them at once,
/// in 0.37 lists per face; with headers and gaps that makes 4.
constexpr std::size_t list_numbers_per_face = 8;

template <class Handle>
void remove_by_name(Connectivity& mesh, Handle handle, const char* name) {
    if (mesh.get_property_handle(handle, name)) {
        mesh.remove_property(handle);
    }
}

/// 12 bytes per face: positions, which are the scan's, and a byte of no data for each vertex, halfedge, edge and face.
void remove_unused_properties(Connectivity& mesh) {
    remove_by_name(mesh, OpenMesh::VPropHandleT<Connectivity::Point>(), "v:points");
    remove_by_name(mesh, OpenMesh::VPropHandleT<Connectivity::VertexData>(), "<vprop>");
    remove_by_name(mesh, OpenMesh::HPropHandleT<Connectivity::HalfedgeData>(), "<hprop>");
    remove_by_name(mesh, OpenMesh::EPropHandleT<Connectivity::EdgeData>(), "<eprop>");
    remove_by_name(mesh, OpenMesh::FPropHandleT<Connectivity::FaceData>(), "<fprop>");
}

/// What is left of the edges and faces, with the new numbers, and all vertices.
std::unique_ptr<Connectivity> without_gaps(const Connectivity& mesh, const Renumbering& numbers) {
    const auto halfedge = [&](Halfedge h) {
        const std::int32_t edge = h.is_valid() ? numbers.edges[h.idx() / 2] : -1;
        return edge < 0 ? Halfedge() : Halfedge(2 * edge + h.idx() % 2);
    };
    auto result = std::make_unique<Connectivity>();
    result->reserve(mesh.n_vertices(), numbers.edges.left(), numbers.faces.left());
    remove_unused_properties(*result);
    for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
        const OpenMesh::VertexHandle vertex(static_cast<int>(v));
        result->set_halfedge_handle(result->new_vertex(), halfedge(mesh.halfedge_handle(vertex)));
        result->status(vertex) = mesh.status(vertex);
    }
    const auto connect = [&](Halfedge h) {
        const OpenMesh::FaceHandle face = mesh.face_handle(h);
        result->set_next_halfedge_handle(halfedge(h), halfedge(mesh.next_halfedge_handle(h)));
        result->set_face_handle(halfedge(h), face.is_valid() ? OpenMesh::FaceHandle(numbers.faces[face.idx()]) : face);
    };
    for (const auto edge : mesh.edges()) {
        const Halfedge along = mesh.halfedge_handle(edge, 0);
        result->new_edge(mesh.from_vertex_handle(along), mesh.to_vertex_handle(along));
    }
    for (const auto edge : mesh.edges()) {
        connect(mesh.halfedge_handle(edge, 0));
        connect(mesh.halfedge_handle(edge, 1));
    }
    for (const auto face : mesh.faces()) {
        result->set_halfedge_handle(result->new_face(), halfedge(mesh.halfedge_handle(face)));
    }
    return result;
}

} // namespace

BaseSurface::BaseSurface(const Scan& scan)
    : scan_(&scan), connectivity_(std::make_unique<Connectivity>()), vertices_(scan.positions.size()),
      faces_(scan.faces.size()), links_(scan.positions.size()),
      coordinates_(std::make_unique_for_overwrite<Coordinates[]>(scan.positions.size())) {
    const std::size_t f_count = scan.faces.size();
    connectivity_->reserve(scan.positions.size(), scan.positions.size() + f_count, f_count);
    lists_.reserve(list_numbers_per_face * f_count); // address space: what is not reached takes no memory
    remove_unused_properties(*connectivity_);
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        connectivity_->new_vertex();
    }
    for (std::size_t f = 0; f < f_count; ++f) {
        const Triangle& face = scan.faces[f];
        const OpenMesh::VertexHandle corners[] = {OpenMesh::VertexHandle(face[0]), OpenMesh::VertexHandle(face[1]),
                                                  OpenMesh::VertexHandle(face[2])};
        if (!connectivity_->add_face(corners, 3).is_valid()) {
            throw RefusedMesh("the faces do not form a manifold");
        }
        faces_[f].list = static_cast<std::int32_t>(f);
    }
}

void BaseSurface::set_vertex(std::int32_t v, const BaseVertex& vertex) {
    assert(vertex.scan_vertex < 0 || (vertex.scan_vertex == v && vertex.position == scan_->positions[v]));
    set_direction(v, vertex.direction);
    if (vertex.scan_vertex >= 0) {
        release_position(v);
        vertices_[v].position = kept;
    } else {
        set_position(v, vertex.position);
    }
}

/// Of a vertex that is not kept.
void BaseSurface::set_position(std::int32_t v, const Vec3& position) {
    std::int32_t& index = vertices_[v].position;
    if (position == scan_->positions[v]) {
        release_position(v);
        index = as_in_the_scan;
    } else if (index >= 0) {
        moved_[index] = position;
    } else {
        index = moved_.add(position);
    }
}

void BaseSurface::set_direction(std::int32_t v, const Vec3& direction) {
    assert(is_float32(direction));
    vertices_[v].direction = {static_cast<float>(direction.x()), static_cast<float>(direction.y()),
                              static_cast<float>(direction.z())};
}

void BaseSurface::drop_vertex(std::int32_t v) {
    release_position(v);
    vertices_[v].position = as_in_the_scan;
}

void BaseSurface::release_position(std::int32_t v) {
    if (vertices_[v].position >= 0) {
        moved_.remove(vertices_[v].position);
    }
}

void BaseSurface::set_face(std::int32_t f, const BaseFace& face) {
    assert(is_float32(face.range.lo) && is_float32(face.range.hi));
    StoredFace& stored = faces_[f];
    if (stored.first_vertex != own_scan_face && stored.list != no_list) {
        lists_.remove(stored.list);
    }
    stored.range = {static_cast<float>(face.range.lo), static_cast<float>(face.range.hi)};
    stored.first_vertex = face.is_scan_face ? own_scan_face : face.first_vertex;
    stored.list = face.is_scan_face         ? first_number(f)
                  : face.scan_faces.empty() ? no_list
                                            : lists_.add(f, face.scan_faces);
    if (lists_.is_wasteful()) {
        lists_.compact([&](std::int32_t owner, ListHandle list) { faces_[owner].list = list; });
    }
}

Triangle BaseSurface::corners(std::int32_t f) const {
    const Halfedge h = connectivity_->halfedge_handle(OpenMesh::FaceHandle(f));
    const Halfedge next = connectivity_->next_halfedge_handle(h);
    return {connectivity_->to_vertex_handle(h).idx(), connectivity_->to_vertex_handle(next).idx(),
            connectivity_->from_vertex_handle(h).idx()};
}

std::int32_t BaseSurface::neighbour(std::int32_t f, int k) const {
    // corners() = {c0, c1, c2} with h from c2 to c0: opposite c0 lies c1 -> c2 (previous), opposite c1 lies h itself.
    Halfedge h = connectivity_->halfedge_handle(OpenMesh::FaceHandle(f));
    if (k == 0) {
        h = connectivity_->prev_halfedge_handle(h);
    } else if (k == 2) {
        h = connectivity_->next_halfedge_handle(h);
    }
    return connectivity_->opposite_face_handle(h).idx();
}

void BaseSurface::append_faces_around(std::int32_t v, std::vector<std::int32_t>& out) const {
    const Halfedge outgoing = connectivity_->halfedge_handle(OpenMesh::VertexHandle(v));
    if (!outgoing.is_valid()) {
        return;
    }
    // OpenMesh lets the outgoing halfedge of a border vertex be the border's: the fan then starts behind it.
    const auto turned = [&](Halfedge h) {
        return connectivity_->opposite_halfedge_handle(connectivity_->prev_halfedge_handle(h));
    };
    Halfedge h = connectivity_->is_boundary(outgoing) ? turned(outgoing) : outgoing;
    do {
        out.push_back(connectivity_->face_handle(h).idx());
        h = turned(h);
    } while (h != outgoing);
}

std::int32_t BaseSurface::any_face_around(std::int32_t v) const {
    const Halfedge outgoing = connectivity_->halfedge_handle(OpenMesh::VertexHandle(v));
    const bool at_border = connectivity_->is_boundary(outgoing);
    return (at_border ? connectivity_->opposite_face_handle(connectivity_->prev_halfedge_handle(outgoing))
                      : connectivity_->face_handle(outgoing))
        .idx();
}

void BaseSurface::close_gaps(const Renumbering& numbers) {
    renumber_faces(numbers.faces);
    connectivity_ = without_gaps(*connectivity_, numbers); // last: the others have given back room for it
}

void BaseSurface::renumber_faces(const NewNumbers& numbers) {
    renumber(faces_, numbers);
    if (first_numbers_.empty()) {
        first_numbers_.resize(numbers.before());
        std::iota(first_numbers_.begin(), first_numbers_.end(), 0);
    }
    renumber(first_numbers_, numbers);
    lists_.renumber_owners(numbers);
    for (Link& link : links_) {
        link.face = link.face < 0 ? link.face : numbers[link.face];
    }
}

void BaseSurface::set_place(std::int32_t scan_vertex, std::int32_t face, const Vec3& alpha, double t) {
    assert(faces_[face].first_vertex != own_scan_face);
    links_[scan_vertex] = {face, faces_[face].first_vertex};
    coordinates_[scan_vertex] = {alpha, t};
    faces_[face].first_vertex = scan_vertex;
}

bool BaseSurface::is_border_vertex(std::int32_t v) const {
    return connectivity_->is_boundary(OpenMesh::VertexHandle(v));
}

} // namespace foldless
