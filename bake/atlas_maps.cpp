#include <foldless/bake/atlas_maps.h>

#include <foldless/bake/chart_samples.h>
#include <foldless/bake/direct_samples.h>
#include <foldless/bake/over_face.h>
#include <foldless/bake/scan_rays.h>
#include <foldless/bake/tangent_frames.h>
#include <foldless/bake/textured_mesh.h>

#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <stdexcept>

namespace foldless {
namespace {

Image blank(int size, std::vector<std::string> channels) {
    Image image{size, size, std::move(channels), {}};
    image.values.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * image.channels.size());
    return image;
}

void set(Image& image, const std::array<int, 2>& texel, float value) {
    image.values[static_cast<std::size_t>(texel[1]) * static_cast<std::size_t>(image.width) +
                 static_cast<std::size_t>(texel[0])] = value;
}

void set(Image& image, const std::array<int, 2>& texel, const Eigen::Vector3f& value) {
    const std::size_t first = 3 * (static_cast<std::size_t>(texel[1]) * static_cast<std::size_t>(image.width) +
                                   static_cast<std::size_t>(texel[0]));
    std::copy_n(value.data(), 3, image.values.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Coordinates for the corners `first`, first + 1, first + 2 (mod 3) as those for the corners 0, 1, 2.
Vec3 in_order_of_face(const Vec3& alpha, int first) {
    Vec3 result;
    for (int k = 0; k < 3; ++k) {
        result[(first + k) % 3] = alpha[k];
    }
    return result;
}

class AtlasBaker {
public:
    AtlasBaker(const BaseMesh& base, const ScanSurface& scan, const SurfaceMap& map, const Atlas& atlas,
               const AtlasMapsOptions& options)
        : base_(base), scan_(scan), map_(map), atlas_(atlas), options_(options) {
        if (options.method == BakeMethod::direct) {
            rays_.emplace(scan.scan());
        }
        const std::vector<std::string> rgb{"R", "G", "B"};
        maps_.displacement = blank(atlas.size, {"Y"});
        maps_.mask = blank(atlas.size, {"Y"});
        maps_.vector = options.vector ? blank(atlas.size, rgb) : Image();
        maps_.normal = options.normal ? blank(atlas.size, rgb) : Image();
        if (options.normal) {
            maps_.tangent_normal = blank(atlas.size, rgb);
            frames_.emplace(TexturedMesh{&base, texture_coordinates(atlas)});
        }
        maps_.colour = options.colour && scan.has_colours() ? blank(atlas.size, rgb) : Image();
    }

    AtlasMaps bake() {
        constexpr std::size_t block = 256; // faces between two calls of the progress function
        const std::size_t faces = base_.faces.size();
        for (std::size_t first = 0; first < faces && !maps_.cancelled; first += block) {
            const std::size_t last = std::min(faces, first + block);
            tbb::parallel_for(first, last, [&](std::size_t face) { bake_face(static_cast<std::int32_t>(face)); });
            maps_.cancelled =
                options_.progress && !options_.progress(static_cast<double>(last) / static_cast<double>(faces));
        }
        maps_.samples = samples_;
        maps_.uncovered = uncovered_;
        maps_.contested = contested_;
        return std::move(maps_);
    }

private:
    /// Charts have no texel in common, so that no two threads write to one.
    void bake_face(std::int32_t face) {
        const Chart& chart = atlas_.charts[face];
        const BaseTriangle triangle = base_triangle(base_, face, chart.corner);
        const FaceSamples samples = samples_on({face, chart.corner, chart.lattice});
        contested_ += samples.contested;
        count(samples);
        for (const ChartSample& sample : with_gutter(samples, triangle, scan_.scan(), atlas_.gutter)) {
            write(face, triangle, sample);
        }
    }

    [[nodiscard]] FaceSamples samples_on(const LatticeOnFace& where) const {
        return rays_ ? direct_samples(base_, *rays_, map_, where) : samples_of(base_, scan_.scan(), map_, where);
    }

    void count(const FaceSamples& samples) {
        std::size_t all = 0;
        std::size_t uncovered = 0;
        for (int j = 0; j <= samples.lattice.rows; ++j) {
            const int last = samples.lattice.last_column(j);
            all += static_cast<std::size_t>(last) + 1;
            for (int i = 0; i <= last; ++i) {
                uncovered += samples.at(i, j).exists() ? 0 : 1;
            }
        }
        samples_ += all;
        uncovered_ += uncovered;
    }

    void write(std::int32_t face, const BaseTriangle& triangle, const ChartSample& sample) {
        const Chart& chart = atlas_.charts[face];
        const std::array<int, 2> texel = chart.texel(sample.i, sample.j);
        const Vec3 alpha = chart.lattice.alpha(sample.i, sample.j);
        set(maps_.displacement, texel, static_cast<float>(sample.point.t));
        set(maps_.mask, texel, sample.is_covered ? 1.0F : 0.0F);
        if (!maps_.vector.values.empty()) {
            const Vec3 d = alpha[0] * triangle.d[0] + alpha[1] * triangle.d[1] + alpha[2] * triangle.d[2];
            set(maps_.vector, texel, (sample.point.t * d).cast<float>());
        }
        if (!maps_.normal.values.empty()) {
            const Eigen::Vector3f normal = scan_.normal(sample.point);
            set(maps_.normal, texel, normal);
            set(maps_.tangent_normal, texel, frames_->in_frame(face, in_order_of_face(alpha, chart.corner), normal));
        }
        if (!maps_.colour.values.empty()) {
            set(maps_.colour, texel, scan_.colour(sample.point));
        }
    }

    const BaseMesh& base_;
    const ScanSurface& scan_;
    const SurfaceMap& map_;
    const Atlas& atlas_;
    const AtlasMapsOptions& options_;
    std::optional<ScanRays> rays_;        ///< for the direct method
    std::optional<TangentFrames> frames_; ///< for normals
    AtlasMaps maps_;
    std::atomic<std::size_t> samples_{0};
    std::atomic<std::size_t> uncovered_{0};
    std::atomic<std::size_t> contested_{0};
};

} // namespace

AtlasMaps bake_atlas(const BaseMesh& base, const ScanSurface& scan, const SurfaceMap& map, const Atlas& atlas,
                     const AtlasMapsOptions& options) {
    if (options.threads.value_or(1) < 1) {
        throw std::invalid_argument("AtlasMapsOptions: threads is less than 1");
    }
    const DefaultArithmetic arithmetic;
    const auto allowed =
        static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    tbb::task_arena arena(std::min(options.threads.value_or(allowed), allowed));
    return arena.execute([&] { return AtlasBaker(base, scan, map, atlas, options).bake(); });
}

} // namespace foldless
