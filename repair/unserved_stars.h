/// \file
/// Spikes that no displacement can reproduce.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

namespace foldless {

/// Drops the faces around each vertex whose faces no direction sees all from the front; false if there is no such
/// vertex. Time O(n).
/// \pre the mesh has no defects
bool drop_unserved_stars(Scan& scan, RepairCounts& counts);

} // namespace foldless
