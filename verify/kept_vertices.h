/// \file
/// Which base vertex is which scan vertex.
#pragma once

#include <foldless/verify/adjacency.h>
#include <foldless/verify/findings.h>

#include <foldless/io/base_mesh.h>

#include <cstdint>
#include <vector>

namespace foldless::verification {

/// The kept vertices: same coordinates, t = 0, known by index.
struct KeptVertices {
    std::vector<std::int32_t> scan_of; ///< the scan vertex that a base vertex is, or -1
    std::vector<std::int32_t> base_of; ///< the base vertex that a scan vertex is kept as, or -1
};

/// Takes the base mesh's word for its kept vertices where that is true: same coordinates, each scan vertex at most
/// once. Every other claim is a `kept_vertex` violation. A base mesh that says nothing (its file has no `scan_vertex`)
/// keeps the vertices that have the coordinates of exactly one scan vertex. Vertices that no face uses are left out.
[[nodiscard]] KeptVertices kept_vertices(const BaseMesh& base, const Scan& scan, const Adjacency& scan_adjacency,
                                         Findings& findings);

} // namespace foldless::verification
