/// \file
/// Vertices that have one texture coordinate each.
#pragma once

#include <foldless/bake/textured_mesh.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// A textured mesh as graphics hardware takes it: all that is known of a face corner hangs on one index.
struct SplitVertices {
    std::vector<std::int32_t> base_vertex;           ///< the base vertex that each is a copy of
    std::vector<Eigen::Vector2f> uv;                 ///< u right, v down, rounded to float32; no minus zero
    std::vector<std::array<std::uint32_t, 3>> faces; ///< as those of the base mesh, in their order
};

/// Copies each base vertex as often as needed and no more: corners of one base vertex share a copy if their rounded
/// texture coordinates are equal. Copies are in the order in which the faces name them; a base vertex without faces has
/// none. Indices must be in range. O(n log n).
[[nodiscard]] SplitVertices split_vertices(const TexturedMesh& mesh);

} // namespace foldless
