/// \file
/// The ranges of a base mesh that has none.
#pragma once

#include <foldless/verify/base_faces.h>
#include <foldless/verify/stages.h>
#include <foldless/verify/topology_checks.h>

namespace foldless::verification {

/// Gives every moving face the hull of the displacements that the association needs in it, rounded outwards to float32
/// as a file would hold them: at the scan vertices, each at its nearest place where J > 0 holds on the way from the
/// base face, at the kept vertices, where scan edges cross the face's walls, and at the pillars inside scan triangles.
/// A face that nothing needs gets [0, 0]. Nothing is proven: the ranges are judged like stored ones.
void set_needed_ranges(BaseFaces& faces, const Meshes& meshes, Stages& stages, double share);

} // namespace foldless::verification
