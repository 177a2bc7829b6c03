/// \file
/// Faces that are no triangles.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

namespace foldless {

/// Drops faces without three different vertices of the mesh, with a corner that is not finite, or whose exact area is
/// zero, and counts each under the first of these. Time O(n).
void drop_bad_faces(Scan& scan, RepairCounts& counts);

} // namespace foldless
