#include <foldless/bake/nearest_face.h>

#include <foldless/bake/embree.h>

#include <cmath>

namespace foldless::distances {
namespace {

/// Embree compares float32 distances between a rounded point and rounded boxes. Coordinates in [-1, 1] are off by
/// 2^-25, the distance of the point from a box by 2 sqrt(3) times that, and the squares that are compared by a few
/// 2^-24 of themselves. What is added to a radius is several times as much, so that no box is left out that it should
/// reach.
constexpr double rounding_of_places = 0x1p-22;
constexpr double rounding_of_squares = 0x1p-20;

float radius_that_reaches(double squared_distance) {
    return static_cast<float>(std::sqrt(squared_distance) * (1 + rounding_of_squares) + rounding_of_places);
}

/// Embree's boxes are rounded to the nearest, which radius_that_reaches() makes up for.
void box_of_face(const RTCBoundsFunctionArguments* arguments) {
    const auto& surface = *static_cast<const Surface*>(arguments->geometryUserPtr);
    const auto [a, b, c] = surface.corners(static_cast<std::int32_t>(arguments->primID));
    const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c).cast<float>();
    const Eigen::Vector3f high = a.cwiseMax(b).cwiseMax(c).cast<float>();
    RTCBounds& box = *arguments->bounds_o;
    box.lower_x = low.x(), box.lower_y = low.y(), box.lower_z = low.z();
    box.upper_x = high.x(), box.upper_y = high.y(), box.upper_z = high.z();
}

/// A question while it is answered.
struct Search {
    const Surface& surface;
    const Vec3& query;
    NearestOnFace best;
};

/// Looks at one face. True if the radius has shrunk.
bool look_at_face(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    const auto face = static_cast<std::int32_t>(arguments->primID);
    const NearestPoint found = nearest_point(search.query, search.surface.corners(face));
    const double least = search.best.nearest.squared_distance;
    if (found.squared_distance > least || (found.squared_distance == least && face >= search.best.face)) {
        return false;
    }
    search.best = {face, found};
    arguments->query->radius = radius_that_reaches(found.squared_distance);
    return found.squared_distance < least;
}

EmbreeScene scene_of(const EmbreeDevice& device, const Surface& surface) {
    const EmbreeGeometry geometry(embree().new_geometry(device.get(), RTC_GEOMETRY_TYPE_USER));
    require_no_error(device);
    embree().set_user_primitive_count(geometry.get(), static_cast<unsigned>(surface.faces.size()));
    embree().set_user_data(geometry.get(), const_cast<Surface*>(&surface)); // Embree hands it back and no more
    embree().set_bounds_function(
        geometry.get(), [](const RTCBoundsFunctionArguments* arguments) { box_of_face(arguments); }, nullptr);
    return embree_scene(device, geometry);
}

} // namespace

NearestFace::NearestFace(const Surface& surface)
    : surface_(surface), device_(embree_device()), scene_(scene_of(device_, surface)) {}

NearestOnFace NearestFace::nearest(const Vec3& query, std::int32_t guess) const {
    Search search{surface_, query, {guess, nearest_on(guess, query)}};
    RTCPointQuery point{};
    point.x = static_cast<float>(query.x());
    point.y = static_cast<float>(query.y());
    point.z = static_cast<float>(query.z());
    point.radius = radius_that_reaches(search.best.nearest.squared_distance);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    embree().point_query(scene_.get(), &point, &context, look_at_face, &search);
    return search.best;
}

} // namespace foldless::distances
