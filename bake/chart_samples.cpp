#include <foldless/bake/chart_samples.h>

#include <foldless/predicates/line_past_edge.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace foldless {
namespace {

/// How many texels a continued face rises or falls from one texel to the next, at most: steep ones would lead anywhere.
constexpr double steepest = 4.0;

/// The displacements that a face may be continued to from one line to another beside it.
Range reachable(const ScanPoint& from, const SampleLine& there, const SampleLine& line, Range range) {
    const double rise = steepest * (line.point() - there.point()).norm() / line.direction().norm();
    return {std::max(range.lo, from.t - rise), std::min(range.hi, from.t + rise)};
}

/// The plane of the scan face of a covered sample where another line meets it, or comes closest to it within what is
/// reachable; the point of the sample itself, if the line does not see the plane from behind.
ScanPoint continued(const ScanPoint& from, const SampleLine& line, Range reach, const Scan& scan) {
    const Triangle& corners = scan.faces[from.face];
    const ScanTriangle q{scan.positions[corners[0]], scan.positions[corners[1]], scan.positions[corners[2]]};
    const Vec3 weights{line.side(q[1], q[2]).value, line.side(q[2], q[0]).value, line.side(q[0], q[1]).value};
    const Vec3 normal = (q[1] - q[0]).cross(q[2] - q[0]);
    const double facing = line.direction().dot(normal);
    if (!(weights.sum() > 0.0 && facing > 0.0)) {
        return from;
    }
    const double t = (q[0] - line.point()).dot(normal) / facing;
    const Vec3 clamped = weights.cwiseMax(0.0) / weights.cwiseMax(0.0).sum();
    return {from.face, std::clamp(t, reach.lo, reach.hi), clamped[1], clamped[2]};
}

constexpr std::size_t nothing = std::numeric_limits<std::size_t>::max();

/// A grid around the lattice, `margin` samples wider on each side.
class Surroundings {
public:
    /// \param is_seed whether a point of the triangle is the source of its own sample
    template <class IsSeed>
    Surroundings(const FaceSamples& samples, int margin, IsSeed is_seed)
        : samples_(samples), margin_(margin), width_(samples.lattice.columns + 1 + 2 * margin),
          height_(samples.lattice.rows + 1 + 2 * margin),
          source_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), nothing) {
        for (int j = 0; j <= samples.lattice.rows; ++j) {
            for (int i = 0; i <= samples.lattice.last_column(j); ++i) {
                if (is_seed(samples.at(i, j))) {
                    source_[index(i, j)] = samples.index(i, j);
                }
            }
        }
        for (int ring = 0; ring < margin; ++ring) {
            grow();
        }
    }

    /// The index of the sample that is the source of another one; `nothing` if none is near.
    [[nodiscard]] std::size_t source(int i, int j) const { return source_[index(i, j)]; }

    template <class Visit>
    void visit(Visit visit) const {
        for (int j = -margin_; j <= samples_.lattice.rows + margin_; ++j) {
            for (int i = -margin_; i <= samples_.lattice.columns + margin_; ++i) {
                if (source_[index(i, j)] != nothing) {
                    visit(i, j, source_[index(i, j)]);
                }
            }
        }
    }

private:
    /// Every sample without a source that has neighbours with one takes over that of the first of them.
    void grow() {
        const std::vector<std::size_t> before = source_;
        for (int j = -margin_; j <= samples_.lattice.rows + margin_; ++j) {
            for (int i = -margin_; i <= samples_.lattice.columns + margin_; ++i) {
                if (before[index(i, j)] == nothing) {
                    source_[index(i, j)] = neighbour(before, i, j);
                }
            }
        }
    }

    [[nodiscard]] std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j + margin_) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(i + margin_);
    }
    [[nodiscard]] std::size_t neighbour(const std::vector<std::size_t>& before, int i, int j) const {
        for (int y = std::max(j - 1, -margin_); y <= std::min(j + 1, samples_.lattice.rows + margin_); ++y) {
            for (int x = std::max(i - 1, -margin_); x <= std::min(i + 1, samples_.lattice.columns + margin_); ++x) {
                if (before[index(x, y)] != nothing) {
                    return before[index(x, y)];
                }
            }
        }
        return nothing;
    }

    const FaceSamples& samples_;
    int margin_;
    int width_;
    int height_;
    std::vector<std::size_t> source_; ///< of each sample: the index of a seed, itself if it is one, or nothing
};

} // namespace

std::vector<ChartSample> with_gutter(const FaceSamples& samples, const BaseTriangle& triangle, const Scan& scan,
                                     int gutter) {
    const Surroundings covered(samples, gutter, [](const ScanPoint& point) { return point.exists(); });
    const Surroundings inside(samples, gutter, [](const ScanPoint&) { return true; });
    std::vector<ChartSample> result;
    covered.visit([&](int i, int j, std::size_t source) {
        const bool is_inside = samples.lattice.contains(i, j);
        const bool is_covered = samples.points[inside.source(i, j)].exists();
        const ScanPoint& point = samples.points[source];
        if (is_inside && is_covered) {
            result.push_back({i, j, is_inside, is_covered, point});
            return;
        }
        const SampleLine line(triangle, samples.lattice.weights(i, j));
        const SampleLine there(triangle, samples.weights(source));
        const Range reach = reachable(point, there, line, samples.range);
        result.push_back({i, j, is_inside, is_covered, continued(point, line, reach, scan)});
    });
    return result;
}

} // namespace foldless
