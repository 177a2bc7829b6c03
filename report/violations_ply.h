/// \file
/// Located violations as a mesh, for a person to look at.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>
#include <foldless/verify/verify.h>

#include <string>

namespace foldless {

/// A PLY (ascii) of the located violations, in their order: for each the position as a red point, the scan face in
/// orange and the base face in blue, as far as there is one. A violation of the topology has no position and is left
/// out. (docs/formats.md)
/// \pre `result` is that of verify(base, scan)
[[nodiscard]] std::string violations_ply(const VerifyResult& result, const BaseMesh& base, const Scan& scan);

} // namespace foldless
