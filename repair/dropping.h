/// \file
/// Taking faces and vertices out of a mesh.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// Drops the faces that are marked, one mark a face; the others keep their order. Returns how many were dropped.
std::size_t drop_marked_faces(Scan& scan, const std::vector<std::uint8_t>& marked);

/// Drops the vertices that no face uses; the others keep their order, and the faces are renumbered.
void drop_unused_vertices(Scan& scan, RepairCounts& counts);

} // namespace foldless
