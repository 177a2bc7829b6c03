#include <foldless/verify/scan_image.h>

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/wall.h>

#include <algorithm>

namespace foldless::verification {
namespace {

/// Whether a line that leaves the kept corner along e certainly does not start in the face: seen along the direction of
/// the corner it turns outwards past one of the two walls there.
bool starts_elsewhere(const MovingFace& face, std::int32_t corner, const Vec3& e) {
    const int k = corner_of(face.corners, corner);
    return Wall(face.triangle, (k + 2) % 3).passes_at_corner(e, 0) == Sign::positive ||
           Wall(face.triangle, (k + 1) % 3).passes_at_corner(e, 1) == Sign::positive;
}

Lifted lift_by_traces(const Correspondents& all, std::int32_t scan_face, const ScanPoint& point) {
    Lifted result;
    std::vector<Foothold> starts;
    // From corners that are not kept first: their face is known. Around a kept vertex several fans between frozen faces
    // may lie over each other, and the way there tells which one is meant.
    std::array<int, 3> order{0, 1, 2};
    std::stable_partition(order.begin(), order.end(), [&](int k) { return all.place(scan_face, k).kept < 0; });
    for (const int k : order) {
        footholds(all.base, all.place(scan_face, k), starts);
        const Line line{all.scan.positions[all.scan.faces[scan_face][k]], point.position, point.error};
        const std::int32_t kept = all.place(scan_face, k).kept;
        if (kept >= 0) {
            std::erase_if(starts, [&](const Foothold& start) {
                return starts_elsewhere(all.base.face(start.face), kept, line.to - line.from);
            });
        }
        const Trace traced = trace(all.base, line, starts, {});
        if (traced.outcome == Trace::Outcome::followed) {
            return {traced.end, false};
        }
        result.undecided = result.undecided || traced.outcome == Trace::Outcome::undecided;
    }
    return result;
}

Lifted lift_by_faces_of_corners(const Correspondents& all, std::int32_t scan_face, const ScanPoint& point) {
    std::vector<Foothold> faces;
    for (int k = 0; k < 3; ++k) {
        footholds(all.base, all.place(scan_face, k), faces);
        for (const Foothold& foothold : faces) {
            if (const auto place = place_in(all.base, foothold.face, point.position, point.error)) {
                return {place, false};
            }
        }
    }
    return {};
}

} // namespace

ScanPoint point_of(const ScanTriangle& q, double u, double v) {
    // Two differences, two products and two sums: at most five roundings of a coordinate's size.
    const double size = std::max({max_norm(q[0]), max_norm(q[1]), max_norm(q[2])});
    return {q[0] + u * (q[1] - q[0]) + v * (q[2] - q[0]), 8 * unit_roundoff * size};
}

std::optional<ScanPoint> pierced_at(const Vec3& v, const Vec3& d, const ScanTriangle& q) {
    std::array<double, 3> weight; // of the corner opposite each edge: twice the area of its projection along d
    for (int k = 0; k < 3; ++k) {
        weight[k] = d.dot((q[(k + 1) % 3] - v).cross(q[(k + 2) % 3] - v));
        if (!(weight[k] >= 0)) {
            return std::nullopt;
        }
    }
    const double sum = weight[0] + weight[1] + weight[2];
    return sum > 0 ? std::optional(point_of(q, weight[1] / sum, weight[2] / sum)) : std::nullopt;
}

ScanTriangle Correspondents::triangle(std::int32_t scan_face) const {
    const Triangle& face = scan.faces[scan_face];
    return {scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
}

Lifted lift(const Correspondents& all, std::int32_t scan_face, std::int32_t home, const ScanPoint& point) {
    if (home >= 0) {
        return {place_in(all.base, home, point.position, point.error), false};
    }
    if (home == no_image) {
        return {};
    }
    return all.base.constant_directions() ? lift_by_faces_of_corners(all, scan_face, point)
                                          : lift_by_traces(all, scan_face, point);
}

bool is_base_edge(const BaseFaces& base, const Place& a, const Place& b) {
    return a.kept >= 0 && b.kept >= 0 &&
           (base.adjacency().face_with(a.kept, b.kept) >= 0 || base.adjacency().face_with(b.kept, a.kept) >= 0);
}

} // namespace foldless::verification
