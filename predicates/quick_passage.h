/// \file
/// What plain doubles can tell of nearly every way of a line through a prismoid. For the sources of this layer only.
#pragma once

#include <foldless/predicates/line_sides.h>
#include <foldless/predicates/prismoid_line.h>

#include <optional>

namespace foldless {

/// A line in a prismoid from one of its points on.
struct LineInPrismoid {
    const BaseTriangle& triangle;
    const ScanLine& line;
    const PrismoidPoint& from;
    const PrismoidPoint* end; ///< null if it is elsewhere
};

/// What follow_line() answers, if bounds on the rounding of doubles decide it with the displacements of the start and
/// of what comes next certainly apart; else nothing. Constant time.
[[nodiscard]] std::optional<Passage> quick_passage(const LineInPrismoid& way, const LineSides& sides);

} // namespace foldless
