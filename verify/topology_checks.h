/// \file
/// Are the two meshes of one topology, and do their borders and the seams of their frozen faces agree?
#pragma once

#include <foldless/verify/base_faces.h>
#include <foldless/verify/findings.h>

namespace foldless::verification {

/// Components, boundary loops and Euler characteristics must be equal: `topology`.
void check_topology(const BaseMesh& base, const Scan& scan, Findings& findings);

/// Whether the border is locked or absent: every border edge of the base mesh is one of the scan between kept vertices,
/// and the other way round. If not, the border is trimmed: the scan maps into the base mesh.
[[nodiscard]] bool border_is_locked(const Meshes& meshes);

/// Where both ends of a scan edge are kept and it is a base edge, the moving faces on either side correspond: a moving
/// scan face that lies on the left of an edge needs a moving base face there, and with a locked border the other way
/// round: `border`.
void check_seams(const Meshes& meshes, const BaseFaces& faces, bool locked, Findings& findings);

} // namespace foldless::verification
