/// \file
/// A base mesh as another program makes it.
#pragma once

#include "made_meshes.h"
#include "random_scans.h"

#include <cstddef>

namespace foldless::test {

/// What CGAL's edge collapse by the costs and placements of Lindstrom and Turk leaves of the scan at so many faces, or
/// as few as it can, the border locked. Its vertices are where it puts them, their directions area-weighted normals.
/// All faces have one range about 0, of a random size. That package of CGAL is under the GPL: nothing but tests may use
/// it.
[[nodiscard]] BaseMesh cgal_base(const Scan& scan, std::size_t faces, Random& random);

} // namespace foldless::test
