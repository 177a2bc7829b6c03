/// \file
/// The samples of a chart and those of its gutter.
#pragma once

#include <foldless/bake/face_raster.h>

#include <foldless/predicates/vector.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// A sample of a chart, inside the triangle or in the gutter around what is covered.
struct ChartSample {
    int i = 0;
    int j = 0;
    bool is_inside = false;  ///< of the triangle
    bool is_covered = false; ///< outside the triangle: as the sample in it from which the gutter grew there
    ScanPoint point;         ///< where inside and covered one of the scan, else in the plane of a face beside it
};

/// All samples that have a value, row by row: those that are covered, and `gutter` rings of continued ones around them,
/// each of which continues the scan face of the first neighbour in the ring before.
[[nodiscard]] std::vector<ChartSample> with_gutter(const FaceSamples& samples, const BaseTriangle& triangle,
                                                   const Scan& scan, int gutter);

} // namespace foldless
