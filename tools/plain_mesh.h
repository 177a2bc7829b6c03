/// \file
/// A mesh to write that is no base mesh.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

namespace foldless {

/// A scan is written as a base mesh that has positions and faces alone.
[[nodiscard]] BaseMesh without_directions(Scan scan);

} // namespace foldless
