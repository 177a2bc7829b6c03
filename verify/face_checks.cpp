#include <foldless/verify/face_checks.h>

#include <foldless/predicates/scan_normal.h>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <iterator>

namespace foldless::verification {
namespace {

bool intersect(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
    return std::any_of(a.begin(), a.end(), [&](std::int32_t x) { return std::binary_search(b.begin(), b.end(), x); });
}

/// Where the line of the plane of a wall crossing is, for a person to look at.
Vec3 position_of(const BaseFaces& base, const WallCrossing& crossing) {
    const BaseTriangle& triangle = base.face(crossing.face).triangle;
    const double t = crossing.t.approximate();
    return 0.5 * (triangle.corner((crossing.wall + 1) % 3, t) + triangle.corner((crossing.wall + 2) % 3, t));
}

} // namespace

std::vector<std::int32_t> faces_of(const BaseFaces& base, const Place& place) {
    std::vector<std::int32_t> faces;
    if (place.pillar >= 0) {
        const auto around = base.adjacency().faces_around(place.pillar);
        std::copy_if(around.begin(), around.end(), std::back_inserter(faces),
                     [&](std::int32_t face) { return base.is_moving(face); });
        return faces;
    }
    faces.push_back(place.face);
    const bool shares_wall = !base.constant_directions() || compare(place.at.t, Displacement()) == Sign::zero;
    for (int k = 0; k < 3; ++k) {
        const std::int32_t across = base.face(place.face).across[k];
        if (shares_wall && (place.at.walls & wall_bit(k)) != 0 && across >= 0) {
            faces.push_back(across);
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

Meetings FaceChecks::check(Stages& stages, double share) {
    stages.for_each(all_.scan.faces.size(), share, [&](std::size_t f) { check_face(static_cast<std::int32_t>(f)); });
    Meetings result;
    for (const Meetings& some : meetings_) {
        result.insert(result.end(), some.begin(), some.end());
    }
    tbb::parallel_sort(result.begin(), result.end());
    return result;
}

void FaceChecks::check_face(std::int32_t face) {
    if (all_.base.scan_face_is_frozen(face) || !all_.has_places(face)) {
        return;
    }
    check_corners(face);
    if (all_.base.constant_directions()) {
        check_prisms(face);
    } else {
        check_image(face);
    }
}

void FaceChecks::add(std::int32_t face, Violation violation, std::int32_t base_face, const Vec3& position) {
    findings_.add({.violation = violation, .scan_face = face, .base_face = base_face, .position = position});
}

void FaceChecks::check_corners(std::int32_t face) {
    const ScanTriangle triangle = all_.triangle(face);
    for (const std::int32_t vertex : all_.scan.faces[face]) {
        const Place& place = all_.association.place(vertex);
        const bool has_own_direction = place.pillar >= 0 && !all_.base.constant_directions();
        const Vec3& q = all_.scan.positions[vertex];
        const Sign sign = has_own_direction
                              ? seen_along(all_.base.mesh().directions[place.pillar], triangle)
                              : normal_condition_at(all_.base.face(place.face).triangle, q, place.at.t, triangle);
        if (sign != Sign::positive) {
            add(face, Violation::normal_condition, place.face, q);
        }
    }
}

void FaceChecks::check_image(std::int32_t face) {
    const ScanTriangle triangle = all_.triangle(face);
    const ScanImage image = image_of(all_, face);
    for (int k = 0; k < 3; ++k) {
        if (!image.edge_is_followed[k] && owns_edge(face, k)) {
            add(face, Violation::trace, face_at(face, k), triangle[k]);
        }
    }
    for (const WallCrossing& crossing : image.crossings) {
        const Sign sign = normal_condition_at_wall(all_.base.face(crossing.face).triangle,
                                                   {crossing.wall, crossing.t, crossing.line}, triangle);
        if (sign != Sign::positive) {
            add(face, Violation::normal_condition, crossing.face, position_of(all_.base, crossing));
        }
    }
    const auto& followed = image.edge_is_followed;
    if (followed[0] && followed[1] && followed[2] && !image.inside) {
        add(face, Violation::pillar, face_at(face, 0), triangle[0]);
    }
    if (image.inside) {
        degree_.count(*image.inside);
    }
    Meetings& meetings = meetings_.local();
    for (const std::int32_t met : image.met) {
        meetings.emplace_back(met, face);
    }
}

/// The prismoids of neighbours with different normals leave gaps or overlap, so that an edge must lie over one face: a
/// right prism is convex.
void FaceChecks::check_prisms(std::int32_t face) {
    std::array<std::vector<std::int32_t>, 3> faces;
    std::vector<std::int32_t> met;
    for (int k = 0; k < 3; ++k) {
        faces[k] = faces_of(all_.base, all_.association.place(all_.scan.faces[face][k]));
        met.insert(met.end(), faces[k].begin(), faces[k].end());
    }
    for (int k = 0; k < 3; ++k) {
        if (!intersect(faces[k], faces[(k + 1) % 3]) && owns_edge(face, k)) {
            add(face, Violation::trace, face_at(face, k), all_.triangle(face)[k]);
        }
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for (const std::int32_t base_face : met) {
        meetings_.local().emplace_back(base_face, face);
    }
}

/// The base face in which corner k of a scan face lies.
std::int32_t FaceChecks::face_at(std::int32_t face, int k) const {
    return all_.association.place(all_.scan.faces[face][k]).face;
}

/// An edge between two moving faces is counted for the lower one.
bool FaceChecks::owns_edge(std::int32_t face, int k) const {
    const std::int32_t across = scan_adjacency_.neighbour(face, (k + 2) % 3);
    return across < 0 || across > face || all_.base.scan_face_is_frozen(across) || !all_.has_places(across);
}

} // namespace foldless::verification
