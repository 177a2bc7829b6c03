/// \file
/// Baking one base face by rays.
#pragma once

#include <foldless/bake/over_face.h>
#include <foldless/bake/scan_rays.h>

#include <foldless/io/base_mesh.h>
#include <foldless/verify/surface_map.h>

namespace foldless {

/// The samples that samples_of() gives, found the other way round: one ray for each, from its place along the
/// interpolated direction over the displacements of the base face (Maggiordomo et al. 2023, section 5.2). It does not
/// ask which scan faces lie over the base face, so that the two check each other. A ray that meets nothing, by rounding
/// or because nothing is there, leaves its sample uncovered. Frozen faces are as there. A sample is contested if its
/// ray passes the scan from behind at several displacements. Expected time: that of a ray for each sample.
[[nodiscard]] FaceSamples direct_samples(const BaseMesh& base, const ScanRays& rays, const SurfaceMap& map,
                                         const LatticeOnFace& where);

} // namespace foldless
