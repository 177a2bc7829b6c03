/// \file
/// What must hold for every scan triangle between the places of its corners.
#pragma once

#include <foldless/verify/scan_image.h>

#include <foldless/predicates/scan_normal.h>

#include <tbb/enumerable_thread_specific.h>

#include <utility>
#include <vector>

namespace foldless::verification {

/// For every moving scan face whose corners have places:
///  - N.n > 0 at its corners (V): `normal_condition`;
///  - its edges can be followed between them (E): `trace`, once per edge, and N.n > 0 at every crossing (X):
///    `normal_condition`; with constant face directions the ends of an edge share a face: `trace`;
///  - its image keeps the orientation if its corners share a base face: `orientation`;
///  - sample points inside it have places with N.n > 0: `interior_sample`.
/// Whatever rounding hides is `undecided`.
class FaceChecks {
public:
    FaceChecks(const Correspondents& all, const Adjacency& scan_adjacency, int samples, Findings& findings);

    [[nodiscard]] ScanImage check(Stages& stages, double share);

private:
    /// A scan face under test.
    struct Subject {
        std::int32_t face;
        ScanTriangle triangle;
        ScanNormal normal;
        std::array<std::vector<Foothold>, 3> corners; ///< the base faces that hold each corner
        std::vector<std::int32_t> met;                ///< base faces that its image may meet
        std::int32_t shared = -1;                     ///< a base face that holds all corners, or -1
        bool stays = true;                            ///< no edge leaves that face
    };

    std::int32_t check_face(std::int32_t face);
    [[nodiscard]] Subject subject(std::int32_t face) const;
    void check_corners(const Subject& subject);
    void check_edge(Subject& subject, int k);
    void check_shared_face(const Subject& subject, int k);
    void check_traced(Subject& subject, int k);
    void check_crossings(Subject& subject, const std::vector<WallCrossing>& crossings);
    void check_orientation(Subject& subject);
    [[nodiscard]] Sign orientation_in(const Subject& subject, std::int32_t base_face) const;
    void check_sample(const Subject& subject, std::int32_t home, int i);
    void meet_pillars(Subject& subject) const;
    void meet_faces_around(std::int32_t vertex, Subject& subject) const;
    void remember(const Subject& subject);
    [[nodiscard]] bool owns_edge(std::int32_t face, int k) const;
    void judge(const Subject& subject, Sign sign, Violation violation);
    void add(const Subject& subject, Violation violation, const Vec3& position);

    const Correspondents& all_;
    const Adjacency& scan_adjacency_;
    int samples_;
    Findings& findings_;
    tbb::enumerable_thread_specific<std::vector<std::pair<std::int32_t, std::int32_t>>> meets_;
};

} // namespace foldless::verification
