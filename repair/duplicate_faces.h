/// \file
/// Faces that a mesh has twice.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

namespace foldless {

/// Drops each face whose three vertices are those of an earlier one, in whatever order: two faces back to back enclose
/// nothing, and a sheet is written once, whichever side is looked at. Time O(n log n).
/// \pre each face has three different vertices of the mesh
void drop_duplicate_faces(Scan& scan, RepairCounts& counts);

} // namespace foldless
