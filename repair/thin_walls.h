/// \file
/// Walls of no thickness that stand on a surface.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// Drops the sheets of faces that were there twice, if the surface is closed where they stood: fins of zippered scans,
/// walls between two parts that are in contact. `doubled` marks the faces of which there was an even number of copies;
/// those that share an edge are a sheet. A sheet goes if each of its edges has an even number of other faces, so that
/// none becomes a border, and some edge has others at all: a sheet that stands alone, written once for either side, is
/// all that there is of its part. Time O(n log n).
/// \pre each face has three different vertices of the mesh, and there are no duplicates
void drop_thin_walls(Scan& scan, const std::vector<std::uint8_t>& doubled, RepairCounts& counts);

} // namespace foldless
