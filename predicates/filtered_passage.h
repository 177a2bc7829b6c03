/// \file
/// What plain doubles can tell of the way of a line through a prismoid. For the sources of this layer only.
#pragma once

#include <foldless/predicates/prismoid_line.h>

#include <optional>

namespace foldless {

/// What follow_line() answers, if bounds on the rounding of doubles decide it, else nothing. Made for lines along which
/// t hardly moves, as over flat parts: where all roots in t lie within rounding of each other, the parameter s of the
/// line still tells the walls apart. Constant time.
[[nodiscard]] std::optional<Passage> filtered_passage(const BaseTriangle& triangle, const ScanLine& line,
                                                      const PrismoidPoint& from, const PrismoidPoint* end);

} // namespace foldless
