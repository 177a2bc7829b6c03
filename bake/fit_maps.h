/// \file
/// How large maps must be to give a scan back as near as is asked for.
#pragma once

#include <foldless/bake/scan_surface.h>
#include <foldless/bake/surface_distance.h>

#include <foldless/io/base_mesh.h>
#include <foldless/verify/surface_map.h>

#include <functional>
#include <optional>

namespace foldless {

struct FitOptions {
    double max_error = 0.0;               ///< model units: the Hausdorff distance that is asked for
    double bound = 0.0;                   ///< model units, positive: distances are known to within it
    int largest = 8192;                   ///< texels on a side, at most
    std::optional<int> threads;           ///< no value: all cores
    std::function<bool(double)> progress; ///< called with the share of the sizes tried; false asks to stop

    static constexpr int smallest = 256; ///< texels on a side, where the search begins
};

/// What was found.
struct MapFit {
    int size = 0;             ///< texels on a side
    int level = 0;            ///< at which reconstruct() was measured
    SurfaceDistance distance; ///< from the scan to that, and back
    bool fits = false;        ///< the distance is proven to be at most what is asked for
    bool cancelled = false;
};

/// The smallest atlas of 256, 512, ... texels on a side, at last `largest`, whose displacement map gives the scan back
/// within the error: measured, not estimated. And for it the lowest level of reconstruct() that does, at most the one
/// whose edges have about four texels each, and none with more than 2^24 faces. If none does, the largest atlas at that
/// level.
///
/// \throws std::invalid_argument for an error that is negative or not a number, and as bake_atlas() and
/// surface_distance() do; AtlasTooSmall if the charts do not fit the largest size.
/// Time: a bake and a comparison for each size, then a comparison for each level.
[[nodiscard]] MapFit fit_maps(const BaseMesh& base, const ScanSurface& scan, const SurfaceMap& map,
                              const FitOptions& options);

} // namespace foldless
