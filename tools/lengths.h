/// \file
/// Lengths in model units.
#pragma once

#include <foldless/tools/command.h>

namespace foldless {

/// \param diagonal of the scan's bounding box, model units
[[nodiscard]] inline double in_model_units(const Length& length, double diagonal) {
    return length.relative ? length.value * diagonal : length.value;
}

/// The largest distance between two surfaces is measured to within this share of the diagonal.
constexpr double comparison_bound = 1e-5;

} // namespace foldless
