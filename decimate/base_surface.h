/// \file
/// The base mesh while it shrinks: an OpenMesh for the connectivity, and beside it what the certificate needs.
#pragma once

#include <foldless/decimate/list_store.h>
#include <foldless/decimate/pool.h>
#include <foldless/decimate/renumbering.h>
#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
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
    Range range{0.0, 0.0};                    ///< displacements over the face, float32 values
    std::span<const std::int32_t> scan_faces; ///< every scan face whose image meets the closed face
    std::int32_t first_vertex = -1; ///< of the scan vertices with their place on it, or -1; see next_on_face()
    bool is_scan_face = true;       ///< still the scan face of the same index, represented by itself
};

/// The place of a scan vertex on the base mesh.
struct Place {
    std::int32_t face = -1; ///< base face, or -1 for a kept vertex
    std::int32_t kept = -1; ///< the base vertex that it is kept as, or -1
    Vec3 alpha = Vec3::Zero();
    double t = 0.0;
};

/// The base mesh, its faces' scan faces, and the places of the scan vertices. Starts as the scan itself: vertex and
/// face indices are those of the scan. Those of vertices stay valid for what survives, those of faces and edges until
/// close_gaps().
///
/// What the scan says of a vertex or face is not stored again: positions of vertices that have not moved, the list of
/// scan faces of a face that is its own, places of kept vertices. What is asked for comes by value; a list of scan
/// faces is valid until the next change.
class BaseSurface {
public:
    /// The scan must outlive the surface. Throws RefusedMesh if OpenMesh cannot hold the scan as a manifold.
    explicit BaseSurface(const Scan& scan);
    explicit BaseSurface(Scan&&) = delete;

    [[nodiscard]] const Connectivity& connectivity() const { return *connectivity_; }
    [[nodiscard]] Connectivity& connectivity() { return *connectivity_; }

    [[nodiscard]] BaseVertex vertex(std::int32_t v) const {
        const StoredVertex& stored = vertices_[v];
        return {stored.position >= 0 ? moved_[stored.position] : scan_->positions[v],
                Vec3(stored.direction[0], stored.direction[1], stored.direction[2]), stored.position == kept ? v : -1};
    }
    /// A vertex that is kept must have the index and the position of its scan vertex.
    void set_vertex(std::int32_t v, const BaseVertex& vertex);
    void set_direction(std::int32_t v, const Vec3& direction);
    /// The vertex is no more: its position and direction are not asked for again.
    void drop_vertex(std::int32_t v);

    [[nodiscard]] BaseFace face(std::int32_t f) const {
        const StoredFace& stored = faces_[f];
        const Range range{stored.range[0], stored.range[1]};
        if (stored.first_vertex == own_scan_face) {
            return {range, {&stored.list, 1}, -1, true};
        }
        return {range, stored.list == no_list ? std::span<const std::int32_t>() : lists_[stored.list],
                stored.first_vertex, false};
    }
    /// The list must not be one of the surface's. That of a face that is its own scan face is that face, whatever it is
    /// given.
    void set_face(std::int32_t f, const BaseFace& face);
    /// The face is no more, or is set next: it has no scan faces and no scan vertices.
    void clear_face(std::int32_t f) { set_face(f, {{0.0, 0.0}, {}, -1, false}); }

    [[nodiscard]] Place place(std::int32_t scan_vertex) const {
        const Link& link = links_[scan_vertex];
        if (link.face < 0) {
            return {-1, scan_vertex, Vec3::Zero(), 0.0};
        }
        return {link.face, -1, coordinates_[scan_vertex].alpha, coordinates_[scan_vertex].t};
    }
    /// The next scan vertex with its place on the same face, or -1.
    [[nodiscard]] std::int32_t next_on_face(std::int32_t scan_vertex) const { return links_[scan_vertex].next_on_face; }
    /// Gives a scan vertex a place on a face that is not its own scan face, of which it becomes the first vertex.
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

    /// Forgets faces and edges that are gone, and gives those that are left the new numbers, which are those of
    /// number_what_is_left(). Time linear in the scan. While it works
    /// it takes up to 66 bytes for each face that is left.
    void close_gaps(const Renumbering& numbers);
    /// The number that a face had at the start.
    [[nodiscard]] std::int32_t first_number(std::int32_t f) const {
        return first_numbers_.empty() ? f : first_numbers_[f];
    }

    [[nodiscard]] std::size_t face_slots() const { return faces_.size(); }
    [[nodiscard]] std::size_t vertex_slots() const { return vertices_.size(); }

private:
    /// Where the position of a vertex is: an index into moved_, or one of these.
    enum : std::int32_t { kept = -1, as_in_the_scan = -2 };
    struct StoredVertex {
        std::array<float, 3> direction{};
        std::int32_t position = kept;
    };
    struct StoredFace {
        std::array<float, 2> range{};
        std::int32_t first_vertex = own_scan_face; ///< that, or -1, or a vertex
        std::int32_t list = no_list;               ///< in lists_; the number of its own scan face
    };
    static constexpr std::int32_t own_scan_face = -2;
    static constexpr std::int32_t no_list = -1;
    /// The chain of the scan vertices on a face, which is followed far more often than their coordinates are read.
    struct Link {
        std::int32_t face = -1; ///< or -1 for a kept vertex
        std::int32_t next_on_face = -1;
    };
    struct Coordinates {
        Vec3 alpha;
        double t;
    };

    void set_position(std::int32_t v, const Vec3& position);
    void release_position(std::int32_t v);
    void renumber_faces(const NewNumbers& numbers);

    const Scan* scan_;
    std::unique_ptr<Connectivity> connectivity_;
    std::vector<StoredVertex> vertices_;
    Pool<Vec3> moved_; ///< positions of vertices that are not where they were in the scan
    std::vector<StoredFace> faces_;
    std::vector<std::int32_t> first_numbers_;    ///< per face; none while they are those of now
    ListStore lists_;                            ///< the scan faces of all faces that are not their own
    std::vector<Link> links_;                    ///< per scan vertex
    std::unique_ptr<Coordinates[]> coordinates_; ///< per scan vertex; set where it is not kept
};

} // namespace foldless
