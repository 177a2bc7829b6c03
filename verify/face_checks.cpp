#include <foldless/verify/face_checks.h>

#include <foldless/verify/sampling.h>

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/scan_orientation.h>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace foldless::verification {
namespace {

bool holds(const std::vector<Foothold>& footholds, std::int32_t face) {
    return std::any_of(footholds.begin(), footholds.end(), [&](const Foothold& f) { return f.face == face; });
}

} // namespace

FaceChecks::FaceChecks(const Correspondents& all, const Adjacency& scan_adjacency, int samples, Findings& findings)
    : all_(all), scan_adjacency_(scan_adjacency), samples_(samples), findings_(findings) {}

ScanImage FaceChecks::check(Stages& stages, double share) {
    ScanImage image;
    image.home.assign(all_.scan.faces.size(), no_image);
    stages.for_each(all_.scan.faces.size(), share,
                    [&](std::size_t f) { image.home[f] = check_face(static_cast<std::int32_t>(f)); });
    for (const auto& some : meets_) {
        image.meets.insert(image.meets.end(), some.begin(), some.end());
    }
    tbb::parallel_sort(image.meets.begin(), image.meets.end());
    return image;
}

std::int32_t FaceChecks::check_face(std::int32_t face) {
    if (all_.base.scan_face_is_frozen(face) || !all_.has_places(face)) {
        return no_image;
    }
    Subject subject = this->subject(face);
    check_corners(subject);
    for (int k = 0; k < 3; ++k) {
        check_edge(subject, k);
    }
    check_orientation(subject);
    if (!subject.stays && !all_.base.constant_directions()) {
        meet_pillars(subject);
    }
    remember(subject);
    const std::int32_t home = subject.stays ? subject.shared : spans_faces;
    for (int i = 0; i < samples_; ++i) {
        check_sample(subject, home, i);
    }
    return home;
}

FaceChecks::Subject FaceChecks::subject(std::int32_t face) const {
    const ScanTriangle triangle = all_.triangle(face);
    Subject result{face, triangle, ScanNormal(triangle), {}, {}, -1, true};
    for (int k = 0; k < 3; ++k) {
        footholds(all_.base, all_.place(face, k), result.corners[k]);
        for (const Foothold& foothold : result.corners[k]) {
            result.met.push_back(foothold.face);
        }
    }
    return result;
}

void FaceChecks::add(const Subject& subject, Violation violation, const Vec3& position) {
    findings_.add({.violation = violation, .scan_face = subject.face, .position = position});
}

void FaceChecks::judge(const Subject& subject, Sign sign, Violation violation) {
    if (sign != Sign::positive) {
        add(subject, sign == Sign::undecided ? Violation::undecided : violation, subject.triangle[0]);
    }
}

void FaceChecks::check_corners(const Subject& subject) {
    for (int k = 0; k < 3; ++k) {
        const Place& place = all_.place(subject.face, k);
        if (place.kept >= 0 && !all_.base.constant_directions()) {
            judge(subject, seen_along(all_.base.mesh().directions[place.kept], subject.triangle),
                  Violation::normal_condition);
            continue;
        }
        const std::int32_t face = place.kept >= 0 ? subject.corners[k].front().face : place.in.face;
        const Enclosure at = coordinates_in(all_.base, place, face, subject.triangle[k]);
        judge(subject, normal_condition(all_.base.face(face).triangle.d, at.alpha, at.alpha_error, subject.normal),
              Violation::normal_condition);
    }
}

/// The edge from corner k to the next.
void FaceChecks::check_edge(Subject& subject, int k) {
    if (all_.base.constant_directions()) {
        check_shared_face(subject, k);
    } else if (!is_base_edge(all_.base, all_.place(subject.face, k), all_.place(subject.face, (k + 1) % 3))) {
        check_traced(subject, k);
    }
}

void FaceChecks::check_shared_face(const Subject& subject, int k) {
    const std::vector<Foothold>& ends = subject.corners[(k + 1) % 3];
    const bool shared = std::any_of(subject.corners[k].begin(), subject.corners[k].end(),
                                    [&](const Foothold& start) { return holds(ends, start.face); });
    if (!shared && owns_edge(subject.face, k)) {
        add(subject, Violation::trace, subject.triangle[k]);
    }
}

void FaceChecks::check_traced(Subject& subject, int k) {
    const int next = (k + 1) % 3;
    // Both faces of an edge follow it from the same end.
    const bool forwards = all_.scan.faces[subject.face][k] < all_.scan.faces[subject.face][next];
    const int a = forwards ? k : next;
    const int b = forwards ? next : k;
    const Trace traced =
        trace(all_.base, {subject.triangle[a], subject.triangle[b]}, subject.corners[a], subject.corners[b]);
    if (traced.outcome == Trace::Outcome::followed) {
        check_crossings(subject, traced.crossings);
        return;
    }
    subject.stays = false;
    if (owns_edge(subject.face, k)) {
        const bool lost = traced.outcome == Trace::Outcome::lost;
        add(subject, lost ? Violation::trace : Violation::undecided, subject.triangle[a]);
    }
}

void FaceChecks::check_crossings(Subject& subject, const std::vector<WallCrossing>& crossings) {
    for (const WallCrossing& crossing : crossings) {
        subject.stays = false;
        subject.met.push_back(crossing.face);
        judge(subject,
              normal_condition(all_.base.face(crossing.face).triangle.d, crossing.alpha, crossing.alpha_error,
                               subject.normal),
              Violation::normal_condition);
    }
}

/// An edge between two moving faces is counted for the lower one.
bool FaceChecks::owns_edge(std::int32_t face, int k) const {
    const std::int32_t across = scan_adjacency_.neighbour(face, (k + 2) % 3);
    return across < 0 || across > face || all_.base.scan_face_is_frozen(across) || !all_.has_places(across);
}

Sign FaceChecks::orientation_in(const Subject& subject, std::int32_t base_face) const {
    BarycentricTriangle alpha;
    std::array<double, 3> error{};
    for (int k = 0; k < 3; ++k) {
        const Enclosure at = coordinates_in(all_.base, all_.place(subject.face, k), base_face, subject.triangle[k]);
        alpha[k] = at.alpha;
        error[k] = at.alpha_error;
    }
    return scan_orientation(alpha, error);
}

/// Of the faces that hold all three corners (more than one only if all lie on one wall) one must see them the right way
/// round. It becomes the subject's shared face.
void FaceChecks::check_orientation(Subject& subject) {
    Sign best = Sign::negative;
    for (const Foothold& foothold : subject.corners[0]) {
        if (!holds(subject.corners[1], foothold.face) || !holds(subject.corners[2], foothold.face)) {
            continue;
        }
        const Sign sign = orientation_in(subject, foothold.face);
        if (subject.shared < 0 || sign == Sign::positive) {
            subject.shared = foothold.face;
            best = sign;
        }
    }
    if (subject.shared >= 0) {
        judge(subject, best, Violation::orientation);
    } else {
        subject.stays = false;
    }
}

void FaceChecks::check_sample(const Subject& subject, std::int32_t home, int i) {
    const Vec3 weights = low_discrepancy_point(static_cast<std::uint64_t>(subject.face), i);
    const ScanPoint point = point_of(subject.triangle, weights[1], weights[2]);
    const Lifted lifted = lift(all_, subject.face, home, point);
    Sign sign = lifted.undecided ? Sign::undecided : Sign::negative;
    if (lifted.place) {
        const Enclosure& at = lifted.place->at;
        sign =
            normal_condition(all_.base.face(lifted.place->face).triangle.d, at.alpha, at.alpha_error, subject.normal);
    }
    if (sign != Sign::positive) {
        add(subject, sign == Sign::undecided ? Violation::undecided : Violation::interior_sample, point.position);
    }
}

/// Adds the moving faces around a base vertex.
void FaceChecks::meet_faces_around(std::int32_t vertex, Subject& subject) const {
    for (const std::int32_t face : all_.base.adjacency().faces_around(vertex)) {
        const bool is_new = std::find(subject.met.begin(), subject.met.end(), face) == subject.met.end();
        if (is_new && all_.base.is_moving(face)) {
            subject.met.push_back(face);
        }
    }
}

/// Adds the faces around every base vertex inside the triangle, going on from face to face: they need neither hold a
/// corner nor be crossed by an edge. That a face is listed proves nothing, so doubles are enough.
void FaceChecks::meet_pillars(Subject& subject) const {
    const BaseMesh& mesh = all_.base.mesh();
    std::vector<std::int32_t> asked;
    for (std::size_t i = 0; i < subject.met.size(); ++i) {
        for (const std::int32_t vertex : all_.base.face(subject.met[i]).corners) {
            if (std::find(asked.begin(), asked.end(), vertex) != asked.end()) {
                continue;
            }
            asked.push_back(vertex);
            if (pierced_at(mesh.positions[vertex], mesh.directions[vertex], subject.triangle)) {
                meet_faces_around(vertex, subject);
            }
        }
    }
}

void FaceChecks::remember(const Subject& subject) {
    auto& meets = meets_.local();
    std::vector<std::int32_t> faces = subject.stays ? std::vector<std::int32_t>{subject.shared} : subject.met;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const std::int32_t face : faces) {
        meets.emplace_back(face, subject.face);
    }
}

} // namespace foldless::verification
