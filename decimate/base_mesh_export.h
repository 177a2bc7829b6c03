/// \file
/// From the base mesh of the loop to what is written.
#pragma once

#include <foldless/decimate/base_surface.h>
#include <foldless/decimate/local_order.h>
#include <foldless/io/base_mesh.h>

namespace foldless {

/// What a decimation leaves.
struct ExportedMesh {
    BaseMesh base;
    Correspondence correspondence;
};

/// The surviving vertices and faces in the order of the scan as it was before `order`, with directions and ranges, and
/// the place of every scan vertex. Vertices that no face uses are left out. With `constant_directions` every face has
/// its own; `float32` says what positions are.
[[nodiscard]] ExportedMesh export_base_mesh(const BaseSurface& surface, const LocalOrder& order,
                                            bool constant_directions, bool float32);

} // namespace foldless
