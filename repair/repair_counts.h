/// \file
/// What a repair did, counted by name.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace foldless {

/// Counts of everything that a repair did; all zero for a mesh that needs nothing. Faces out are faces in less those
/// that were dropped, vertices out are vertices in and added less those that were dropped.
struct RepairCounts {
    std::size_t out_of_range_faces = 0;    ///< dropped: an index is no vertex
    std::size_t repeated_index_faces = 0;  ///< dropped: a vertex is named twice
    std::size_t not_finite_faces = 0;      ///< dropped: a corner has a coordinate that is NaN or infinite
    std::size_t zero_area_faces = 0;       ///< dropped: the exact area is zero
    std::size_t duplicate_faces = 0;       ///< dropped: an earlier face has the same vertices, whatever its orientation
    std::size_t thin_wall_faces = 0;       ///< dropped: they had a duplicate, and the surface closes without them
    std::size_t turned_faces = 0;          ///< turned over: the second and third corner changed places
    std::size_t unorientable_edges = 0;    ///< edges of two faces cut open, as no turning makes them agree
    std::size_t non_manifold_edges = 0;    ///< edges of three or more faces that were taken apart
    std::size_t split_vertices = 0;        ///< vertices of several fans, of which the first kept the vertex
    std::size_t added_vertices = 0;        ///< copies for the other fans
    std::size_t unserved_vertices = 0;     ///< whose faces were dropped, as no direction sees them all from the front
    std::size_t unserved_faces = 0;        ///< these faces
    std::size_t small_components = 0;      ///< dropped: fewer faces than was asked for
    std::size_t small_component_faces = 0; ///< the faces of these
    std::size_t dropped_vertices = 0;      ///< that no face uses, from the start or now

    [[nodiscard]] bool any() const;
    /// "2 zero-area faces dropped, 1 face turned over": each count by name; empty if nothing was done.
    [[nodiscard]] std::string text() const;
};

/// The words for a count.
struct RepairCountName {
    std::size_t RepairCounts::*count;
    const char* key; ///< in reports
    const char* one;
    const char* many;
};

inline constexpr std::array<RepairCountName, 16> repair_count_names{{
    {&RepairCounts::out_of_range_faces, "out_of_range_faces", "face with an index out of range dropped",
     "faces with an index out of range dropped"},
    {&RepairCounts::repeated_index_faces, "repeated_index_faces", "face with a repeated index dropped",
     "faces with a repeated index dropped"},
    {&RepairCounts::not_finite_faces, "not_finite_faces", "face with a corner that is not finite dropped",
     "faces with a corner that is not finite dropped"},
    {&RepairCounts::zero_area_faces, "zero_area_faces", "zero-area face dropped", "zero-area faces dropped"},
    {&RepairCounts::duplicate_faces, "duplicate_faces", "duplicate face dropped", "duplicate faces dropped"},
    {&RepairCounts::thin_wall_faces, "thin_wall_faces", "face of a wall of no thickness dropped",
     "faces of walls of no thickness dropped"},
    {&RepairCounts::turned_faces, "turned_faces", "face turned over", "faces turned over"},
    {&RepairCounts::unorientable_edges, "unorientable_edges", "edge cut open for want of an orientation",
     "edges cut open for want of an orientation"},
    {&RepairCounts::non_manifold_edges, "non_manifold_edges", "non-manifold edge taken apart",
     "non-manifold edges taken apart"},
    {&RepairCounts::split_vertices, "split_vertices", "vertex split", "vertices split"},
    {&RepairCounts::added_vertices, "added_vertices", "vertex added", "vertices added"},
    {&RepairCounts::unserved_vertices, "unserved_vertices", "unserved vertex removed", "unserved vertices removed"},
    {&RepairCounts::unserved_faces, "unserved_faces", "face around unserved vertices dropped",
     "faces around unserved vertices dropped"},
    {&RepairCounts::small_components, "small_components", "small component dropped", "small components dropped"},
    {&RepairCounts::small_component_faces, "small_component_faces", "face of small components dropped",
     "faces of small components dropped"},
    {&RepairCounts::dropped_vertices, "dropped_vertices", "unused vertex dropped", "unused vertices dropped"},
}};

} // namespace foldless
