#include <foldless/bake/scan_rays.h>

#include <foldless/bake/embree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace foldless {
namespace {

/// A place in the box is off by 2^-25 in float32, for the corners of a face as for the ends of a ray, and what Embree
/// computes of them by a few 2^-24. A ray is longer by this at both ends, in units of the box.
constexpr double rounding_of_places = 0x1p-20;

/// Displacements that differ by less, in units of the box, are one place: two faces that meet in an edge.
constexpr double one_place = 2 * rounding_of_places;

struct Box {
    Vec3 centre = Vec3::Zero();
    double size = 1.0;
};

Box box_around(const Scan& scan) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t vertex : face) {
            low = low.cwiseMin(scan.positions[vertex]);
            high = high.cwiseMax(scan.positions[vertex]);
        }
    }
    const double size = (high - low).maxCoeff();
    return size > 0.0 ? Box{low + (high - low) / 2, size} : Box{};
}

/// A point of the face for a line that passes it within rounding: where it passes beside an edge, one of the edge.
/// Nothing if it does not pass from behind.
std::optional<ScanPoint> point_passed(const SampleLine& line, const Scan& scan, std::int32_t face) {
    const auto& [a, b, c] = scan.faces[face];
    const ScanTriangle q{scan.positions[a], scan.positions[b], scan.positions[c]};
    Vec3 weights;
    for (int k = 0; k < 3; ++k) {
        weights[k] = line.side(q[(k + 1) % 3], q[(k + 2) % 3]).value;
    }
    if (!(weights.sum() > 0.0)) { // d.n
        return std::nullopt;
    }
    weights = weights.cwiseMax(0.0);
    weights /= weights.sum();
    const Vec3 point = weights[0] * q[0] + weights[1] * q[1] + weights[2] * q[2];
    const Vec3& d = line.direction();
    return ScanPoint{face, (point - line.point()).dot(d) / d.squaredNorm(), weights[1], weights[2]};
}

/// A ray on its way. Embree hands the context back.
struct Flight : RTCIntersectContext {
    const Scan& scan;
    const SampleLine& line;
    Range range;
    ScanPoint nearest;
    double least = std::numeric_limits<double>::infinity(); ///< of all displacements
    double most = -std::numeric_limits<double>::infinity();

    Flight(const Scan& hit, const SampleLine& along, Range displacements)
        : RTCIntersectContext(), scan(hit), line(along), range(displacements) {
        rtcInitIntersectContext(this);
    }

    void meet(std::int32_t face) {
        const std::optional<ScanPoint> point = point_passed(line, scan, face);
        if (!point || point->t < range.lo || point->t > range.hi) {
            return;
        }
        least = std::min(least, point->t);
        most = std::max(most, point->t);
        const double further = std::abs(point->t) - std::abs(nearest.t);
        if (!nearest.exists() || further < 0.0 || (further == 0.0 && face < nearest.face)) {
            nearest = *point;
        }
    }
};

/// Takes note of a face and lets the ray go on, so that it meets all of them.
void look_at_hit(const RTCFilterFunctionNArguments* arguments) {
    auto& flight = *static_cast<Flight*>(arguments->context);
    flight.meet(static_cast<std::int32_t>(RTCHitN_primID(arguments->hit, arguments->N, 0)));
    arguments->valid[0] = 0;
}

/// The corners of all faces as float32; vertices without faces, which may lie anywhere, come to the centre.
void copy_positions(float* to, const Scan& scan, const Box& box) {
    std::fill_n(to, 3 * scan.positions.size(), 0.0F);
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t vertex : face) {
            const Eigen::Vector3f place = ((scan.positions[vertex] - box.centre) / box.size).cast<float>();
            std::copy_n(place.data(), 3, to + 3 * static_cast<std::ptrdiff_t>(vertex));
        }
    }
}

void copy_faces(unsigned* to, const Scan& scan) {
    for (const Triangle& face : scan.faces) {
        to = std::transform(face.begin(), face.end(), to, [](std::int32_t v) { return static_cast<unsigned>(v); });
    }
}

EmbreeScene scene_of(const EmbreeDevice& device, const Scan& scan, const Box& box) {
    const EmbreeGeometry geometry(embree().new_geometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    require_no_error(device);
    void* positions = embree().set_new_geometry_buffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                       3 * sizeof(float), scan.positions.size());
    void* faces = embree().set_new_geometry_buffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                   3 * sizeof(unsigned), scan.faces.size());
    require_no_error(device);
    copy_positions(static_cast<float*>(positions), scan, box);
    copy_faces(static_cast<unsigned*>(faces), scan);
    embree().set_occluded_filter_function(geometry.get(), look_at_hit);
    return embree_scene(device, geometry);
}

/// From the least displacement to the largest. \pre the direction is not zero
RTCRay ray_along(const SampleLine& line, Range range, const Box& box) {
    const Vec3 start = (line.point() + range.lo * line.direction() - box.centre) / box.size;
    const Vec3 end = (line.point() + range.hi * line.direction() - box.centre) / box.size;
    const Vec3 direction = line.direction().normalized();
    const Eigen::Vector3f from = start.cast<float>();
    const Eigen::Vector3f to = direction.cast<float>();
    RTCRay ray{};
    ray.org_x = from.x(), ray.org_y = from.y(), ray.org_z = from.z();
    ray.dir_x = to.x(), ray.dir_y = to.y(), ray.dir_z = to.z();
    ray.tnear = 0.0F;
    ray.tfar = static_cast<float>((end - start).norm());
    ray.mask = ~0U;
    return ray;
}

} // namespace

ScanRays::ScanRays(const Scan& scan) : scan_(scan), device_(embree_device()) {
    const Box box = box_around(scan);
    centre_ = box.centre;
    size_ = box.size;
    scene_ = scene_of(device_, scan, box);
}

RayPassage ScanRays::passage(const SampleLine& line, Range range) const {
    const double length = line.direction().norm();
    if (!(length > 0.0)) {
        return {};
    }
    const double slack = rounding_of_places * size_ / length; // in units of the direction
    const Range longer{range.lo - slack, range.hi + slack};
    Flight flight(scan_, line, longer);
    RTCRay ray = ray_along(line, longer, {centre_, size_});
    embree().occluded1(scene_.get(), &flight, &ray);
    RayPassage result{flight.nearest, flight.most - flight.least > one_place * size_ / length};
    result.point.t = std::clamp(result.point.t, range.lo, range.hi);
    return result;
}

} // namespace foldless
