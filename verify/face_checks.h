/// \file
/// What must hold for every scan triangle: the conditions V, E, X and P of theorem B (docs/certificate.md).
#pragma once

#include <foldless/verify/degree.h>
#include <foldless/verify/findings.h>
#include <foldless/verify/scan_image.h>
#include <foldless/verify/stages.h>

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace foldless::verification {

/// (base face, scan face) for every base face that the image of a scan face meets, ascending.
using Meetings = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// For every moving scan face whose corners have places, exactly:
///  - m > 0 at its corners (V) and where its edges cross walls (X): `normal_condition`;
///  - its edges can be followed from place to place (E): `trace`, once per edge;
///  - the base vertices inside fit the crossings (P): `pillar`.
/// With constant face directions instead: N.n > 0 in a face of each corner, and the two ends of an edge share a face.
class FaceChecks {
public:
    FaceChecks(const Correspondents& all, const Adjacency& scan_adjacency, Degree& degree, Findings& findings)
        : all_(all), scan_adjacency_(scan_adjacency), degree_(degree), findings_(findings) {}

    [[nodiscard]] Meetings check(Stages& stages, double share);

private:
    void check_face(std::int32_t face);
    void check_corners(std::int32_t face);
    void check_image(std::int32_t face);
    void check_prisms(std::int32_t face);
    void add(std::int32_t face, Violation violation, std::int32_t base_face, const Vec3& position);
    [[nodiscard]] std::int32_t face_at(std::int32_t face, int k) const;
    [[nodiscard]] bool owns_edge(std::int32_t face, int k) const;

    const Correspondents& all_;
    const Adjacency& scan_adjacency_;
    Degree& degree_;
    Findings& findings_;
    tbb::enumerable_thread_specific<Meetings> meetings_;
};

/// The moving faces that hold a place, ascending: one, or both at a wall, or all around a pillar. With constant face
/// directions a place off the base surface belongs to one face alone.
[[nodiscard]] std::vector<std::int32_t> faces_of(const BaseFaces& base, const Place& place);

} // namespace foldless::verification
