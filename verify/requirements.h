/// \file
/// What the two meshes must be before anything can be asked of them.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

namespace foldless::verification {

/// \throws RefusedMesh if either mesh has a defect (see io/defects.h), or the base mesh has no directions, one that is
/// not finite, or arrays of other lengths than its vertices or faces.
void require_usable(const BaseMesh& base, const Scan& scan);

} // namespace foldless::verification
