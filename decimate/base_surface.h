/// \file
/// The base mesh while it shrinks: an OpenMesh for the connectivity, and beside it what the certificate needs.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <array>
#include <cstdint>
#include <vector>

namespace foldless {

struct BaseSurfaceTraits : OpenMesh::DefaultTraits {
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::None);
};
using Connectivity = OpenMesh::TriMesh_ArrayKernelT<BaseSurfaceTraits>;

/// A vertex of the base mesh.
struct BaseVertex {
    Vec3 position;
    Vec3 direction;           ///< displacement direction, a float32 value
    std::int32_t scan_vertex; ///< the scan vertex that it is kept as, or -1
};

/// A face of the base mesh with the scan faces whose image meets it.
struct BaseFace {
    Range range{0.0, 0.0};                ///< displacements over the face, float32 values
    std::vector<std::int32_t> scan_faces; ///< every scan face whose image meets the closed face
    std::int32_t first_vertex = -1;       ///< of the scan vertices with their place on it, or -1; see next_on_face()
    bool is_scan_face = true;             ///< still the scan face of the same index, represented by itself
};

/// The place of a scan vertex on the base mesh.
struct Place {
    std::int32_t face = -1; ///< base face, or -1 for a kept vertex
    std::int32_t kept = -1; ///< the base vertex that it is kept as, or -1
    Vec3 alpha = Vec3::Zero();
    double t = 0.0;
};

/// The base mesh, its faces' scan faces, and the places of the scan vertices. Starts as the scan itself: vertex and
/// face indices are those of the scan and stay valid for what survives.
class BaseSurface {
public:
    /// Throws RefusedMesh if OpenMesh cannot hold the scan as a manifold.
    explicit BaseSurface(const Scan& scan);

    [[nodiscard]] const Connectivity& connectivity() const { return connectivity_; }
    [[nodiscard]] Connectivity& connectivity() { return connectivity_; }

    [[nodiscard]] const BaseVertex& vertex(std::int32_t v) const { return vertices_[v]; }
    [[nodiscard]] BaseVertex& vertex(std::int32_t v) { return vertices_[v]; }
    [[nodiscard]] const BaseFace& face(std::int32_t f) const { return faces_[f]; }
    [[nodiscard]] BaseFace& face(std::int32_t f) { return faces_[f]; }
    [[nodiscard]] const Place& place(std::int32_t scan_vertex) const { return places_[scan_vertex]; }
    /// The next scan vertex with its place on the same face, or -1.
    [[nodiscard]] std::int32_t next_on_face(std::int32_t scan_vertex) const { return next_on_face_[scan_vertex]; }
    /// Gives a scan vertex a place on a face, of which it becomes the first vertex.
    void set_place(std::int32_t scan_vertex, std::int32_t face, const Vec3& alpha, double t);

    /// Corners of a face in its orientation. A collapse leaves their order as it is.
    [[nodiscard]] Triangle corners(std::int32_t f) const;
    /// The face across the edge opposite corner k (in the order of corners()), or -1.
    [[nodiscard]] std::int32_t neighbour(std::int32_t f, int k) const;
    /// Appends the faces around a vertex, counter-clockwise, a fan from border to border or a full cycle.
    void append_faces_around(std::int32_t v, std::vector<std::int32_t>& out) const;
    /// The first of them; the vertex must have one.
    [[nodiscard]] std::int32_t any_face_around(std::int32_t v) const;
    [[nodiscard]] bool is_border_vertex(std::int32_t v) const;

    [[nodiscard]] std::size_t face_slots() const { return faces_.size(); }
    [[nodiscard]] std::size_t vertex_slots() const { return vertices_.size(); }

private:
    Connectivity connectivity_;
    std::vector<BaseVertex> vertices_;
    std::vector<BaseFace> faces_;
    std::vector<Place> places_;
    std::vector<std::int32_t> next_on_face_; ///< per scan vertex
};

} // namespace foldless
