/// \file
/// How large a scan is.
#pragma once

#include <foldless/io/scan.h>

namespace foldless {

/// The diagonal of the box around the vertices that faces use, model units; 0 without faces. Time O(n).
[[nodiscard]] double bounding_box_diagonal(const Scan& scan);

} // namespace foldless
