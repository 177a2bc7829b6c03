/// \file
/// The faces of a base mesh that represent themselves.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

#include <cstddef>

namespace foldless {

/// How many faces of the base mesh are a face of the scan, corner for corner in the same orientation, with the range
/// [0, 0]. Time O((F + f) log f) for F scan and f base faces, memory O(f).
[[nodiscard]] std::size_t count_frozen_faces(const BaseMesh& base, const Scan& scan);

} // namespace foldless
