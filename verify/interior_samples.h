/// \file
/// Points inside the scan triangles, with constant face directions: a sample, where no proof is.
#pragma once

#include <foldless/verify/findings.h>
#include <foldless/verify/scan_image.h>
#include <foldless/verify/stages.h>

namespace foldless::verification {

/// Sample points inside every moving scan face must lie in the prismoid of a face that holds one of its corners, with
/// N.n > 0: `interior_sample`.
void check_interior_samples(const Correspondents& all, int samples_per_face, Stages& stages, Findings& findings);

} // namespace foldless::verification
