#include <foldless/bake/atlas.h>

#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_rect_pack.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

namespace foldless {
namespace {

/// A face as its chart sees it: the corner opposite the longest edge, and the lengths of the legs to the next corner
/// and to the one after.
struct Legs {
    int corner;
    double along;
    double up;
};

Legs legs_of(const BaseMesh& base, const Triangle& face) {
    std::array<double, 3> opposite;
    for (int k = 0; k < 3; ++k) {
        opposite[k] = (base.positions[face[(k + 1) % 3]] - base.positions[face[(k + 2) % 3]]).norm();
    }
    const int corner = static_cast<int>(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
    return {corner, opposite[(corner + 2) % 3], opposite[(corner + 1) % 3]};
}

/// Two faces in one rectangle, or one face and nothing.
struct Pair {
    std::int32_t first;
    std::int32_t second;   ///< or -1
    SampleLattice lattice; ///< of both
};

/// Texels between the two long edges of a pair: both gutters, and the rounding of both edges.
int gap(int gutter) {
    return 2 * gutter + 2;
}

class Packing {
public:
    Packing(std::vector<Legs> legs, const AtlasOptions& options) : legs_(std::move(legs)), options_(options) {}

    /// The charts with `scale` texels per length, if they fit.
    [[nodiscard]] std::optional<std::vector<Chart>> pack(double scale) const {
        const std::vector<Pair> pairs = paired(scale);
        std::vector<stbrp_rect> rectangles;
        rectangles.reserve(pairs.size());
        for (const Pair& pair : pairs) {
            const int more = (pair.second < 0 ? 1 : 1 + gap(options_.gutter)) + 2 * options_.gutter;
            const int width = pair.lattice.columns + more;
            const int height = pair.lattice.rows + more;
            if (width > options_.size || height > options_.size) {
                return std::nullopt;
            }
            rectangles.push_back({static_cast<int>(rectangles.size()), width, height, 0, 0, 0});
        }
        stbrp_context context;
        std::vector<stbrp_node> nodes(static_cast<std::size_t>(options_.size));
        stbrp_init_target(&context, options_.size, options_.size, nodes.data(), options_.size);
        if (stbrp_pack_rects(&context, rectangles.data(), static_cast<int>(rectangles.size())) == 0) {
            return std::nullopt;
        }
        return charts(pairs, rectangles);
    }

    /// An upper bound on the scale: the charts alone would fill the picture.
    [[nodiscard]] double largest_scale() const {
        double area = 0.0;
        for (const Legs& legs : legs_) {
            area += 0.5 * legs.along * legs.up;
        }
        return area > 0.0 ? options_.size / std::sqrt(area) : 0.0;
    }

private:
    [[nodiscard]] SampleLattice lattice(const Legs& legs, double scale) const {
        const auto texels = [&](double length) {
            return static_cast<int>(std::clamp(std::round(length * scale), 1.0, static_cast<double>(options_.size)));
        };
        return {texels(legs.along), texels(legs.up)};
    }

    /// Faces of about the same size share a rectangle, as large as the larger one needs it.
    [[nodiscard]] std::vector<Pair> paired(double scale) const {
        std::vector<SampleLattice> lattices;
        lattices.reserve(legs_.size());
        for (const Legs& legs : legs_) {
            lattices.push_back(lattice(legs, scale));
        }
        std::vector<std::int32_t> order(legs_.size());
        std::iota(order.begin(), order.end(), 0);
        const auto key = [&](std::int32_t face) {
            const SampleLattice& size = lattices[face];
            return std::array{bracket(size.rows), size.columns, size.rows, face};
        };
        std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return key(a) > key(b); });
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < order.size(); i += 2) {
            const SampleLattice& first = lattices[order[i]];
            if (i + 1 == order.size()) {
                pairs.push_back({order[i], -1, first});
                break;
            }
            const SampleLattice& second = lattices[order[i + 1]];
            pairs.push_back(
                {order[i], order[i + 1], {std::max(first.columns, second.columns), std::max(first.rows, second.rows)}});
        }
        return pairs;
    }

    /// Numbers that differ by less than an eighth are one bracket.
    [[nodiscard]] static int bracket(int count) {
        constexpr double brackets_per_octave = 6.0;
        return static_cast<int>(std::log2(static_cast<double>(count)) * brackets_per_octave);
    }

    [[nodiscard]] std::vector<Chart> charts(const std::vector<Pair>& pairs,
                                            const std::vector<stbrp_rect>& rectangles) const {
        std::vector<Chart> result(legs_.size());
        for (const stbrp_rect& rectangle : rectangles) {
            const Pair& pair = pairs[static_cast<std::size_t>(rectangle.id)];
            const int left = rectangle.x + options_.gutter;
            const int right = rectangle.x + rectangle.w - 1 - options_.gutter;
            const int top = rectangle.y + options_.gutter;
            const int bottom = rectangle.y + rectangle.h - 1 - options_.gutter;
            result[pair.first] = {legs_[pair.first].corner, pair.lattice, left, bottom, false};
            if (pair.second >= 0) {
                result[pair.second] = {legs_[pair.second].corner, pair.lattice, right, top, true};
            }
        }
        return result;
    }

    std::vector<Legs> legs_;
    AtlasOptions options_;
};

} // namespace

Eigen::Vector2d Atlas::coordinates(std::int32_t face, int corner) const {
    const Chart& chart = charts[face];
    const int at = (corner - chart.corner + 3) % 3;
    const std::array<int, 2> texel = chart.texel(at == 1 ? chart.lattice.columns : 0, at == 2 ? chart.lattice.rows : 0);
    return {(texel[0] + 0.5) / size, (texel[1] + 0.5) / size}; // the centre of the texel
}

std::vector<std::array<Eigen::Vector2d, 3>> texture_coordinates(const Atlas& atlas) {
    std::vector<std::array<Eigen::Vector2d, 3>> uv;
    uv.reserve(atlas.charts.size());
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(atlas.charts.size()); ++face) {
        uv.push_back({atlas.coordinates(face, 0), atlas.coordinates(face, 1), atlas.coordinates(face, 2)});
    }
    return uv;
}

Atlas make_atlas(const BaseMesh& base, const AtlasOptions& options) {
    std::vector<Legs> legs;
    legs.reserve(base.faces.size());
    for (const Triangle& face : base.faces) {
        legs.push_back(legs_of(base, face));
    }
    const Packing packing(std::move(legs), options);
    double fits = 0.0;
    double too_large = packing.largest_scale();
    std::optional<std::vector<Chart>> charts = packing.pack(fits);
    if (!charts) {
        throw AtlasTooSmall("an atlas of " + std::to_string(options.size) + " x " + std::to_string(options.size) +
                            " has no room for " + std::to_string(base.faces.size()) + " charts");
    }
    constexpr int halvings = 20; // the last one is less than a texel in a million
    for (int i = 0; i < halvings; ++i) {
        const double scale = 0.5 * (fits + too_large);
        if (std::optional<std::vector<Chart>> larger = packing.pack(scale)) {
            charts = std::move(larger);
            fits = scale;
        } else {
            too_large = scale;
        }
    }
    return {options.size, options.gutter, std::move(*charts)};
}

} // namespace foldless
