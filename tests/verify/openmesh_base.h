/// \file
/// A base mesh as another program makes it.
#pragma once

#include "made_meshes.h"
#include "random_scans.h"

#include <cstddef>

namespace foldless::test {

/// What OpenMesh's decimation by quadrics leaves of the scan at so many faces, or as few as it can, the border locked:
/// its vertices are scan vertices, their directions area-weighted normals. All faces have one range about 0, of a
/// random size.
[[nodiscard]] BaseMesh openmesh_base(const Scan& scan, std::size_t faces, Random& random);

} // namespace foldless::test
