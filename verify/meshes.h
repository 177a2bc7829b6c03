/// \file
/// What is given: the two meshes.
#pragma once

#include <foldless/verify/adjacency.h>
#include <foldless/verify/kept_vertices.h>

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

namespace foldless::verification {

/// Both meshes with their adjacency, and what is kept.
struct Meshes {
    const BaseMesh& base;
    const Scan& scan;
    const Adjacency& base_adjacency;
    const Adjacency& scan_adjacency;
    const KeptVertices& kept;
};

} // namespace foldless::verification
