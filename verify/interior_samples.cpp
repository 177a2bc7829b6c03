#include <foldless/verify/interior_samples.h>

#include <foldless/verify/face_checks.h>
#include <foldless/verify/sampling.h>

#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/scan_normal.h>

#include <algorithm>

namespace foldless::verification {
namespace {

void check_face(const Correspondents& all, std::int32_t face, int samples_per_face, Findings& findings) {
    const ScanTriangle q = all.triangle(face);
    std::vector<std::int32_t> candidates;
    for (const std::int32_t vertex : all.scan.faces[face]) {
        const std::vector<std::int32_t> some = faces_of(all.base, all.association.place(vertex));
        std::copy_if(some.begin(), some.end(), std::back_inserter(candidates),
                     [&](std::int32_t f) { return all.base.face(f).is_fold_free(); });
    }
    for (int i = 0; i < samples_per_face; ++i) {
        const Vec3 weights = low_discrepancy_point(static_cast<std::uint64_t>(face), i);
        const Vec3 point = q[0] + weights[1] * (q[1] - q[0]) + weights[2] * (q[2] - q[0]);
        const auto holds = [&](std::int32_t f) {
            const MovingFace& base_face = all.base.face(f);
            return seen_along(base_face.triangle.d[0], q) == Sign::positive &&
                   PointFinder(base_face.triangle, base_face.range).find(point).has_value();
        };
        if (std::none_of(candidates.begin(), candidates.end(), holds)) {
            findings.add({.violation = Violation::interior_sample, .scan_face = face, .position = point});
        }
    }
}

} // namespace

void check_interior_samples(const Correspondents& all, int samples_per_face, Stages& stages, Findings& findings) {
    stages.for_each(all.scan.faces.size(), 0.0, [&](std::size_t f) {
        const auto face = static_cast<std::int32_t>(f);
        if (!all.base.scan_face_is_frozen(face) && all.has_places(face)) {
            check_face(all, face, samples_per_face, findings);
        }
    });
}

} // namespace foldless::verification
