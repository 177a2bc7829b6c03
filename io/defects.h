/// \file
/// What a mesh is made of and what is wrong with it.
#pragma once

#include <foldless/io/errors.h>
#include <foldless/io/scan.h>

#include <cstddef>
#include <string>

namespace foldless {

/// Counts of everything for which a mesh is refused; all zero for a mesh that can be used. Edges and fans are those of
/// the faces that name three different vertices of the mesh.
struct Defects {
    std::size_t no_faces = 0;           ///< 1 if the mesh has no face
    std::size_t not_finite = 0;         ///< vertices with a coordinate that is NaN or infinite
    std::size_t index_out_of_range = 0; ///< faces
    std::size_t repeated_index = 0;     ///< faces that name a vertex twice
    std::size_t zero_area = 0;          ///< faces of three different finite vertices whose exact area is zero
    std::size_t non_manifold_edges = 0; ///< edges of three or more faces
    std::size_t inconsistent_edges = 0; ///< edges whose two faces run along them in the same direction

    /// Vertices whose faces form more than one fan, where faces are neighbours over edges of two faces. The ends of a
    /// non-manifold edge are among them.
    std::size_t non_manifold_vertices = 0;

    /// Parts, connected over edges of two faces, that no turning over of faces makes consistent.
    std::size_t non_orientable_components = 0;

    [[nodiscard]] bool any() const;
    /// "3 non-manifold edges, 1 zero-area face": each defect counted by name; empty if there is none.
    [[nodiscard]] std::string text() const;
};

/// The topology of a mesh; meaningful when it has no defects.
struct Topology {
    std::size_t unused_vertices = 0; ///< vertices that no face uses
    std::size_t components = 0;      ///< connected over shared vertices
    std::size_t boundary_loops = 0;
    std::size_t boundary_edges = 0;
    long long euler_characteristic = 0; ///< used vertices - edges + faces
};

struct Inspection {
    Defects defects;
    Topology topology;
};

/// Inspects positions and faces. Time O(n log n), memory O(n). Never throws on bad meshes.
[[nodiscard]] Inspection inspect(const Scan& scan);

/// \throws RefusedMesh with Defects::text() if the mesh has any defect.
void require_no_defects(const Scan& scan);

} // namespace foldless
