#include <foldless/bake/atlas_sampler.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foldless {

AtlasSampler::AtlasSampler(const Atlas& atlas, const Image& displacement, const Image& mask)
    : atlas_(atlas), displacement_(displacement), mask_(mask) {}

MapValue AtlasSampler::value(std::int32_t face, const Vec3& alpha) const {
    const Chart& chart = atlas_.charts[face];
    const Cell cell = cell_of(chart, alpha);
    const double coverage = mask_.values.empty() ? 1.0 : interpolated(mask_, chart, cell);
    return {interpolated(displacement_, chart, cell), coverage};
}

AtlasSampler::Cell AtlasSampler::cell_of(const Chart& chart, const Vec3& alpha) {
    const double x = alpha[(chart.corner + 1) % 3] * chart.lattice.columns;
    const double y = alpha[(chart.corner + 2) % 3] * chart.lattice.rows;
    const int i = std::clamp(static_cast<int>(std::floor(x)), 0, chart.lattice.columns - 1);
    const int j = std::clamp(static_cast<int>(std::floor(y)), 0, chart.lattice.rows - 1);
    return {i, j, x - i, y - j};
}

double AtlasSampler::interpolated(const Image& image, const Chart& chart, const Cell& cell) const {
    const auto at = [&](int i, int j) {
        const std::array<int, 2> texel = chart.texel(i, j);
        return static_cast<double>(
            image.values[static_cast<std::size_t>(texel[1]) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(texel[0])]);
    };
    const auto between = [](double a, double b, double share) {
        return share == 0.0 ? a : share == 1.0 ? b : (1.0 - share) * a + share * b;
    };
    return between(between(at(cell.i, cell.j), at(cell.i + 1, cell.j), cell.along),
                   between(at(cell.i, cell.j + 1), at(cell.i + 1, cell.j + 1), cell.along), cell.up);
}

} // namespace foldless
