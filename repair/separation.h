/// \file
/// Takes apart what is no manifold.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

namespace foldless {

/// Gives each fan of faces around a vertex a vertex of its own: the fan with the first face keeps the vertex, each
/// other gets a copy at the end of the positions. Faces are neighbours in a fan over edges of two faces that agree in
/// orientation, and over edges of more faces where they continue each other (continuations.h) and that leaves no edge
/// of three faces. Afterwards every edge has one face, or two that agree, and every vertex one fan. Time O(n log n).
/// \pre each face has three different vertices of the mesh
void separate_fans(Scan& scan, RepairCounts& counts);

} // namespace foldless
