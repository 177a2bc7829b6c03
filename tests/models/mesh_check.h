/// \file
/// Judges a generated mesh from its arrays alone, sharing no code with what made it nor with the library's own check.
#pragma once

#include <foldless/io/scan.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

struct MeshCheck {
    std::size_t bad_faces = 0;  ///< with an index out of range or twice the same
    std::size_t flat_faces = 0; ///< with an area of zero
    std::size_t repeated_half_edges =
        0;                            ///< two faces along an edge in the same direction: non-manifold or inconsistent
    std::size_t pinched_vertices = 0; ///< whose faces are not one fan
    std::size_t unused_vertices = 0;
    std::size_t equal_positions = 0; ///< vertices that lie exactly where an earlier one does
    std::size_t components = 0;
    std::size_t boundary_edges = 0;
    std::size_t boundary_loops = 0;
    long long euler_characteristic = 0;
    double volume = 0; ///< enclosed, positive if the faces are oriented outward; of closed meshes
};

[[nodiscard]] MeshCheck check_mesh(const Scan& scan);

/// Unit normals of the faces at a vertex.
[[nodiscard]] std::vector<Vec3> normals_at(const Scan& scan, std::int32_t vertex);

/// Whether an edge of a face passes through another face with which it shares no vertex. Time O(faces^2) at worst.
[[nodiscard]] bool crosses_itself(const Scan& scan);

} // namespace foldless
