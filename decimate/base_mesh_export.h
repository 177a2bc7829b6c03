/// \file
/// From the base mesh of the loop to what is written.
#pragma once

#include <foldless/decimate/base_surface.h>
#include <foldless/io/base_mesh.h>

namespace foldless {

/// The surviving vertices and faces in the order of their indices, with directions and ranges, and the place of every
/// scan vertex. Vertices that no face uses are left out. With `constant_directions` every face has its own.
void export_base_mesh(const BaseSurface& surface, const Scan& scan, bool constant_directions, BaseMesh& base,
                      Correspondence& correspondence);

} // namespace foldless
