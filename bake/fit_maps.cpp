#include <foldless/bake/fit_maps.h>

#include <foldless/bake/atlas.h>
#include <foldless/bake/atlas_maps.h>
#include <foldless/bake/atlas_sampler.h>
#include <foldless/bake/reconstruct.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace foldless {
namespace {

constexpr int texels_of_an_edge = 4;
constexpr std::size_t most_faces = std::size_t{1} << 24; // of a reconstruction: they take about a gigabyte

/// The lowest level whose edges have no more texels, or the highest one that does not have too many faces.
int finest_level(const Atlas& atlas) {
    int longest = 1;
    for (const Chart& chart : atlas.charts) {
        longest = std::max({longest, chart.lattice.columns, chart.lattice.rows});
    }
    int level = 0;
    while (level < ReconstructOptions::max_level && texels_of_an_edge << level < longest &&
           atlas.charts.size() << (2 * (level + 1)) <= most_faces) {
        ++level;
    }
    return level;
}

/// From small to large.
std::vector<int> sizes(int largest) {
    std::vector<int> result;
    for (int size = std::min(FitOptions::smallest, largest); size < largest; size = std::min(2 * size, largest)) {
        result.push_back(size);
    }
    result.push_back(largest);
    return result;
}

class MapFitter {
public:
    MapFitter(const BaseMesh& base, const ScanSurface& scan, const SurfaceMap& map, const FitOptions& options)
        : base_(base), scan_(scan), map_(map), options_(options) {}

    MapFit fit() {
        const std::vector<int> all = sizes(options_.largest);
        for (std::size_t i = 0; i < all.size() && !found_.fits && !found_.cancelled; ++i) {
            found_.cancelled =
                options_.progress && !options_.progress(static_cast<double>(i) / static_cast<double>(all.size()));
            if (!found_.cancelled) {
                try_size(all[i]);
            }
        }
        return found_;
    }

private:
    void try_size(int size) {
        AtlasOptions atlas_options;
        atlas_options.size = size;
        try {
            measure(make_atlas(base_, atlas_options));
        } catch (const AtlasTooSmall&) {
            if (size == options_.largest) {
                throw;
            }
        }
    }

    void measure(const Atlas& atlas) {
        AtlasMapsOptions options;
        options.vector = false;
        options.normal = false;
        options.colour = false;
        options.threads = options_.threads;
        const AtlasMaps maps = bake_atlas(base_, scan_, map_, atlas, options);
        const AtlasSampler sampler(atlas, maps.displacement, maps.mask);
        int level = finest_level(atlas);
        found_ = at_level(atlas.size, sampler, level);
        while (found_.fits && level > 0) {
            --level;
            const MapFit lower = at_level(atlas.size, sampler, level);
            if (!lower.fits) {
                return;
            }
            found_ = lower;
        }
    }

    /// Nothing is left of a scan that lies between the samples.
    MapFit at_level(int size, const AtlasSampler& sampler, int level) const {
        MapFit fit;
        fit.size = size;
        fit.level = level;
        const auto value_at = [&](std::int32_t face, const Vec3& alpha) { return sampler.value(face, alpha); };
        const Scan surface = reconstruct(base_, value_at, {level, options_.threads});
        if (!surface.faces.empty()) {
            DistanceOptions options;
            options.bound = options_.bound;
            options.threads = options_.threads;
            fit.distance = surface_distance(scan_.scan(), surface, options);
            fit.fits = fit.distance.maximum_bound() <= options_.max_error;
        }
        return fit;
    }

    const BaseMesh& base_;
    const ScanSurface& scan_;
    const SurfaceMap& map_;
    const FitOptions& options_;
    MapFit found_;
};

} // namespace

MapFit fit_maps(const BaseMesh& base, const ScanSurface& scan, const SurfaceMap& map, const FitOptions& options) {
    if (!(options.max_error >= 0.0)) {
        throw std::invalid_argument("FitOptions: the error is negative or not a number");
    }
    if (options.largest < 1) {
        throw std::invalid_argument("FitOptions: no atlas is that small");
    }
    return MapFitter(base, scan, map, options).fit();
}

} // namespace foldless
