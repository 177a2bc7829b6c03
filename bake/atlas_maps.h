/// \file
/// Baking the maps of an atlas.
#pragma once

#include <foldless/bake/atlas.h>
#include <foldless/bake/scan_surface.h>

#include <foldless/images/image.h>
#include <foldless/io/base_mesh.h>
#include <foldless/verify/surface_map.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace foldless {

/// How the point of the scan for a sample is found. (Maggiordomo et al. 2023, section 5)
enum class BakeMethod {
    inverse, ///< scan faces are drawn into the charts, by exact signs: no sample over the scan is left out
    direct,  ///< a ray is cast from each sample, in float32: a check of the other, by other means
};

struct AtlasMapsOptions {
    BakeMethod method = BakeMethod::inverse;
    bool vector = true;                   ///< bake the displacement vectors too
    bool normal = true;                   ///< and the normals of the scan
    bool colour = true;                   ///< and its colours, if it has any
    std::optional<int> threads;           ///< no value: all cores
    std::function<bool(double)> progress; ///< called with the share done, 0 to 1; false asks to stop
};

/// Maps over one atlas, rows from the top. Beside the charts they hold zeros.
struct AtlasMaps {
    Image displacement;   ///< one channel: t, in units of the interpolated direction
    Image mask;           ///< one channel: 1 where the scan covers the base mesh, else 0
    Image vector;         ///< t d, model units; empty if not asked for
    Image normal;         ///< in object space, of length 1; empty if not asked for
    Image tangent_normal; ///< the same in the frames of the textured base mesh (tangent_frames.h); empty as `normal`
    Image colour;         ///< as the scan has it, 0 to 1; empty if not asked for, or the scan has none

    bool cancelled = false;
    std::size_t samples = 0;   ///< inside the charts
    std::size_t uncovered = 0; ///< of these, displaced to nothing: where a trimmed scan ends, or a ray meets nothing
    std::size_t contested = 0; ///< of these, claimed by several faces (face_raster.h, direct_samples.h)
};

/// Each sample of each chart gets the point of the scan that it is displaced to, and so do as many texels around the
/// covered ones as the gutter is wide: there the scan face of the nearest covered sample is continued in its plane. The
/// same bytes for any number of threads.
///
/// \throws std::invalid_argument for less than one thread; by the direct method std::runtime_error where Embree cannot
/// run.
/// Memory: the maps, and for each thread the samples of one face; by the direct method a hierarchy over the scan faces,
/// too. Time O(texels + scan faces); by the direct method that of a ray for each sample.
[[nodiscard]] AtlasMaps bake_atlas(const BaseMesh& base, const ScanSurface& scan, const SurfaceMap& map,
                                   const Atlas& atlas, const AtlasMapsOptions& options = {});

} // namespace foldless
