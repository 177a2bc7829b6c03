#include <foldless/bake/triangle_distance.h>

#include <algorithm>
#include <utility>

namespace foldless::distances {
namespace {

/// The point a + t edge with 0 <= t <= 1 nearest to the query; `to_query` leads from a to the query.
///
/// t is off by a few roundings of |to_query| / |edge|, so that the point moves by as many of |to_query| along the edge,
/// however short that is.
NearestPoint nearest_on_edge(const Vec3& to_query, const Vec3& a, const Vec3& edge) {
    const double length_squared = edge.squaredNorm();
    const double along = to_query.dot(edge);
    const double t = along <= 0.0 ? 0.0 : along >= length_squared ? 1.0 : along / length_squared;
    return {a + t * edge, (to_query - t * edge).squaredNorm()};
}

const NearestPoint& nearer(const NearestPoint& first, const NearestPoint& second) {
    return second.squared_distance < first.squared_distance ? second : first;
}

/// The corners in an order in which the first two are the ends of the longest edge.
ScanTriangle longest_edge_first(const ScanTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    const double ab = (b - a).squaredNorm();
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    if (ab >= bc && ab >= ca) {
        return triangle;
    }
    return bc >= ca ? ScanTriangle{b, c, a} : ScanTriangle{c, a, b};
}

} // namespace

//            c
//          . | .        The frame is the longest edge and the height on it. The direction of the height is off by a few
//        .   |p  .      roundings of |edge| / |p|, which turns the plane about the edge: by a few roundings of |edge|
//        at
//      .     |     .    c. Along the height, the foot of the query moves by a few roundings of D |edge| / |p|, where D
//     a------+------b   is its distance from the line ab; but by no more than |p| within the triangle, and across the
//         edge          line of sight. Either way that is a few roundings of |edge| in the distance.
NearestPoint nearest_point(const Vec3& query, const ScanTriangle& triangle) {
    const auto [a, b, c] = longest_edge_first(triangle);
    const Vec3 edge = b - a;
    const Vec3 side = c - a;
    const Vec3 to_query = query - a;
    const double length_squared = edge.squaredNorm();
    if (!(length_squared > 0.0)) {
        return {a, to_query.squaredNorm()};
    }
    const double foot = side.dot(edge) / length_squared; // of c on the edge
    const Vec3 p = side - foot * edge;
    const double height_squared = p.squaredNorm();
    const double t = to_query.dot(edge) / length_squared;
    const Vec3 across = to_query - t * edge;
    const double at_c = height_squared > 0.0 ? across.dot(p) / height_squared : 0.0;
    const double at_b = t - at_c * foot;
    if (at_c > 0.0 && at_b > 0.0 && at_c + at_b < 1.0) {
        return {a + t * edge + at_c * p, (across - at_c * p).squaredNorm()};
    }
    return nearer(nearer(nearest_on_edge(to_query, a, edge), nearest_on_edge(to_query, a, side)),
                  nearest_on_edge(query - b, b, c - b));
}

} // namespace foldless::distances
