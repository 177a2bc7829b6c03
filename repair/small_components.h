/// \file
/// Crumbs of a scan.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

#include <cstddef>

namespace foldless {

/// Drops components, connected over shared vertices, of fewer than `least` faces. Time O(n).
/// \pre each face has three vertices of the mesh
void drop_small_components(Scan& scan, std::size_t least, RepairCounts& counts);

} // namespace foldless
