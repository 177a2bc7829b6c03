/// \file
/// Faces that a mesh has twice.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// Drops each face whose three vertices are those of an earlier one, in whatever order: two faces back to back enclose
/// nothing, and a sheet is written once, whichever side is looked at. Time O(n log n).
///
/// Returns a mark for each face that is left: 1 if the number of its copies, itself among them, was even. Around a
/// surface that closes without them such faces are thin walls (thin_walls.h).
/// \pre each face has three different vertices of the mesh
std::vector<std::uint8_t> drop_duplicate_faces(Scan& scan, RepairCounts& counts);

} // namespace foldless
