#include <foldless/bake/surface_distance.h>

#include <foldless/bake/distance_refinement.h>
#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace foldless {
namespace {

using namespace distances;

/// Of all work, for one side; only the progress function reads them.
constexpr double share_of_index = 0.1;
constexpr double share_of_samples = 0.3;
constexpr double share_of_refinement = 0.1;

/// Bounds the rounding of every distance, in units of the size: a position is off by two roundings of it, a point of a
/// split face by a few more, and a distance by what nearest_point() states.
constexpr double rounding_of_distances = 0x1p-44;

/// The least bound that leaves room for the rounding.
constexpr double least_bound = 0x1p-40;

void require_usable(const Scan& scan, const char* name) {
    const std::string mesh = std::string("surface_distance: the mesh `") + name + "` has ";
    if (scan.faces.empty()) {
        throw std::invalid_argument(mesh + "no faces");
    }
    const auto vertices = static_cast<std::int32_t>(scan.positions.size());
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t vertex : face) {
            if (vertex < 0 || vertex >= vertices) {
                throw std::invalid_argument(mesh + "a face with a vertex that does not exist");
            }
            if (!scan.positions[vertex].allFinite()) {
                throw std::invalid_argument(mesh + "a coordinate that is not finite");
            }
        }
    }
}

void require_sensible(const DistanceOptions& options) {
    if (!(options.bound > 0.0) || !std::isfinite(options.bound)) {
        throw std::invalid_argument("DistanceOptions: bound is not positive and finite");
    }
    if (options.threads.value_or(1) < 1) {
        throw std::invalid_argument("DistanceOptions: threads is less than 1");
    }
}

/// From model units to a box with the origin at its centre and sides of at most 1, and back. The factor is a power of
/// two: only the shift rounds, relative to the size of the box. Halves are taken first, as a sum may overflow.
class Frame {
public:
    Frame(const Scan& first, const Scan& second) {
        extend(first);
        extend(second);
        half_centre_ = low_ / 4 + high_ / 4;
        half_size_ = (high_ / 2 - low_ / 2).maxCoeff();
        int exponent = 0;
        if (half_size_ > 0.0) {
            std::frexp(half_size_, &exponent);
        }
        exponent_ = -exponent;
    }

    /// Of the box in units of the frame: in [1/2, 1), or 0.
    [[nodiscard]] double size() const { return length_in_frame(half_size_) * 2; }

    [[nodiscard]] double length_in_frame(double length) const { return std::ldexp(length / 2, exponent_); }

    [[nodiscard]] double length(double in_frame) const { return 2 * std::ldexp(in_frame, -exponent_); }

    [[nodiscard]] Vec3 position(const Vec3& in_frame) const {
        return 2 * (in_frame.unaryExpr([this](double x) { return std::ldexp(x, -exponent_); }) + half_centre_);
    }

    /// Vertices without faces, which may lie anywhere, come to the origin.
    [[nodiscard]] Surface surface(const Scan& scan) const {
        Surface result{std::vector<Vec3>(scan.positions.size(), Vec3::Zero()), scan.faces};
        for (const Triangle& face : scan.faces) {
            for (const std::int32_t vertex : face) {
                result.positions[vertex] = (scan.positions[vertex] / 2 - half_centre_).unaryExpr([this](double x) {
                    return std::ldexp(x, exponent_);
                });
            }
        }
        return result;
    }

private:
    void extend(const Scan& scan) {
        for (const Triangle& face : scan.faces) {
            for (const std::int32_t vertex : face) {
                low_ = low_.cwiseMin(scan.positions[vertex]);
                high_ = high_.cwiseMax(scan.positions[vertex]);
            }
        }
    }

    Vec3 low_ = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
    Vec3 half_centre_;
    double half_size_;
    int exponent_;
};

/// What both sides share.
struct Measurement {
    const Frame& frame;
    double bound; ///< in units of the frame, for the refinement
    double rounding;
    BlockLoop& loop;

    [[nodiscard]] OneSidedDistance one_sided(const Surface& surface, const Surface& other) const {
        OneSidedDistance result;
        const NearestFace nearest_face(other);
        loop.finish(share_of_index);
        const SampledSurface samples = sampled(surface, nearest_face, loop, share_of_samples);
        if (loop.cancelled()) {
            return result;
        }
        const Maximum maximum = refined_maximum(samples, surface.faces, nearest_face, bound, loop, share_of_refinement);
        const Sample& furthest = maximum.furthest;
        result.maximum = frame.length(furthest.distance);
        result.maximum_bound = frame.length(maximum.upper + rounding);
        result.rms = samples.area > 0.0 ? frame.length(std::sqrt(samples.integral / samples.area)) : 0.0;
        result.furthest = frame.position(furthest.position);
        result.nearest = frame.position(nearest_face.nearest_on(furthest.face, furthest.position).point);
        return result;
    }
};

SurfaceDistance run(const Scan& from, const Scan& to, const DistanceOptions& options) {
    const Frame frame(from, to);
    const double bound = frame.length_in_frame(options.bound);
    if (bound < least_bound * frame.size()) {
        throw std::invalid_argument("DistanceOptions: bound is below 2^-40 of the size of the meshes");
    }
    const Surface surface = frame.surface(from);
    const Surface other = frame.surface(to);
    BlockLoop loop(options.progress);
    const double rounding = rounding_of_distances * frame.size();
    const Measurement measurement{frame, bound - 2 * rounding, rounding, loop};
    SurfaceDistance result;
    result.there = measurement.one_sided(surface, other);
    if (!loop.cancelled()) {
        result.back = measurement.one_sided(other, surface);
    }
    result.cancelled = loop.cancelled();
    return result;
}

/// As many threads as are asked for; never more than the process may have.
int concurrency(const DistanceOptions& options) {
    const auto allowed =
        static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return std::min(options.threads.value_or(allowed), allowed);
}

} // namespace

SurfaceDistance surface_distance(const Scan& from, const Scan& to, const DistanceOptions& options) {
    require_sensible(options);
    require_usable(from, "from");
    require_usable(to, "to");
    const DefaultArithmetic arithmetic;
    tbb::task_arena arena(concurrency(options)); // its threads compute as this one does
    return arena.execute([&] { return run(from, to, options); });
}

} // namespace foldless
