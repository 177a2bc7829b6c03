#include <foldless/bake/face_raster.h>

#include <foldless/bake/edge_rows.h>
#include <foldless/bake/image_box.h>
#include <foldless/bake/piercing.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace foldless {
namespace {

/// The samples k / count between lo and hi, one more on each side.
std::pair<int, int> samples_between(double lo, double hi, int count) {
    const double n = count;
    const double first = std::clamp(std::floor(lo * n), 0.0, n + 1.0);
    const double last = std::clamp(std::ceil(hi * n), -1.0, n);
    return {static_cast<int>(first), static_cast<int>(last)};
}

class Raster {
public:
    Raster(const BaseTriangle& triangle, Range range, const Scan& scan, FaceSamples& samples)
        : triangle_(triangle), range_(range), scan_(scan), samples_(samples), slack_(slack()) {}

    void draw(std::int32_t scan_face) {
        const Triangle& corners = scan_.faces[scan_face];
        const ScanTriangle q{scan_.positions[corners[0]], scan_.positions[corners[1]], scan_.positions[corners[2]]};
        const std::optional<AlphaBox> found = image_box(triangle_, range_, q);
        if (!found) {
            return;
        }
        const AlphaBox& box = *found;
        const EdgeRows rows(triangle_, q);
        const auto [first_row, last_row] = samples_between(box.lo[2], box.hi[2], samples_.lattice.rows);
        for (int j = first_row; j <= last_row; ++j) {
            const double alpha2 = static_cast<double>(j) / samples_.lattice.rows;
            const Span within{std::max(box.lo[1], 1.0 - alpha2 - box.hi[0]),
                              std::min(box.hi[1], 1.0 - alpha2 - box.lo[0])};
            const Span span = rows.narrowed(within, alpha2);
            if (span.empty()) {
                continue;
            }
            const auto [first, last] = samples_between(span.lo, span.hi, samples_.lattice.columns);
            for (int i = first; i <= std::min(last, samples_.lattice.last_column(j)); ++i) {
                claim(i, j, scan_face, q);
            }
        }
    }

private:
    /// What rounding may do to a displacement, generously: less than what lies between two sheets of a scan.
    [[nodiscard]] double slack() const {
        double size = std::max(std::abs(range_.lo), std::abs(range_.hi)); // in units of the directions
        for (int i = 0; i < 3; ++i) {
            const double length = max_norm(triangle_.d[i]);
            size = std::max(size, length > 0.0 ? max_norm(triangle_.v[i]) / length : 0.0);
        }
        constexpr double share = 1e-10;
        return share * size;
    }

    void claim(int i, int j, std::int32_t face, const ScanTriangle& q) {
        const SampleLine line(triangle_, samples_.lattice.weights(i, j));
        const std::optional<Piercing> passed = piercing(line, q);
        if (!passed || passed->t < range_.lo - slack_ || passed->t > range_.hi + slack_) {
            return;
        }
        ScanPoint& point = samples_.at(i, j);
        const double t = std::clamp(passed->t, range_.lo, range_.hi);
        if (point.exists()) {
            if (std::abs(t - point.t) <= slack_) {
                return; // on an edge or a vertex of the scan: the lower face has it
            }
            ++samples_.contested;
            if (std::abs(t) >= std::abs(point.t)) {
                return;
            }
        }
        point = {face, t, passed->weights[1], passed->weights[2]};
    }

    const BaseTriangle& triangle_;
    Range range_;
    const Scan& scan_;
    FaceSamples& samples_;
    double slack_;
};

} // namespace

FaceSamples rasterise(const BaseTriangle& triangle, Range range, const Scan& scan, std::span<const std::int32_t> over,
                      const SampleLattice& lattice) {
    FaceSamples samples(lattice, range);
    Raster raster(triangle, range, scan, samples);
    for (const std::int32_t face : over) {
        raster.draw(face);
    }
    return samples;
}

} // namespace foldless
