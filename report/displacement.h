/// \file
/// How far the vertices of a scan lie from its base mesh.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

namespace foldless {

/// Signed displacements t |d|, d being the interpolated direction; model units. All zero without scan vertices.
struct DisplacementStatistics {
    double min = 0.0;
    double max = 0.0;
    double rms = 0.0;                      ///< root of the mean square over the scan vertices that faces use
    double max_relative_to_diagonal = 0.0; ///< the largest magnitude over the diagonal of the scan's bounding box
};

/// The displacements of the scan's vertices on the base mesh. Each place must lie in a face of `base` or be -1.
/// Time O(scan vertices).
[[nodiscard]] DisplacementStatistics displacement_statistics(const BaseMesh& base, const Correspondence& correspondence,
                                                             double diagonal);

/// Fills in what follows from the other fields.
[[nodiscard]] DisplacementStatistics with_share_of_diagonal(DisplacementStatistics statistics, double diagonal);

} // namespace foldless
