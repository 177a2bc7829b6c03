/// \file
/// One orientation for the faces of a part.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

namespace foldless {

/// Turns faces over until neighbours over edges of two faces agree, wherever the part that such edges connect has two
/// sides. Of the two ways the one that turns fewer faces is taken, of two equal ones that which leaves the first face.
///
/// A part that has one side only cannot agree at every edge. It is oriented outwards from its first face, first over
/// edges that agree already: one that disagrees along a single seam is left as it is. The edges that disagree then are
/// left to separate_fans(). Time O(n log n).
/// \pre each face has three different vertices of the mesh
void turn_faces(Scan& scan, RepairCounts& counts);

} // namespace foldless
