/// \file
/// The guard: may a patch take the place of the faces that go?
#pragma once

#include <foldless/decimate/direction_cone.h>
#include <foldless/decimate/edge_trace.h>
#include <foldless/decimate/faces_beside.h>
#include <foldless/decimate/marks.h>
#include <foldless/decimate/patch_image.h>
#include <foldless/decimate/patch_ranges.h>
#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/pillars.h>
#include <foldless/decimate/point_location.h>
#include <foldless/decimate/prepared_scan.h>
#include <foldless/decimate/prismoid.h>
#include <foldless/decimate/trial.h>
#include <foldless/decimate/trimmed_patch.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/scan_orientation.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace foldless {

struct ValidatorOptions {
    Uniqueness uniqueness = Uniqueness::in_range;
    bool constant_directions = false;       ///< each face is displaced along its own normal
    bool trimmed = false;                   ///< the scan's border need not be the base mesh's
    bool orientation = false;               ///< the test of Maggiordomo et al. 2023, section 5.2, besides
    std::optional<double> max_displacement; ///< bound on |t| |d| over whole faces, model units
};

/// Judges patches against the current base mesh, of which it knows nothing but what a Patch and a BaseSurface say: not
/// whether the change is a collapse, a flip or a relocation.
///
/// Accepted means: every scan vertex on the patch has exactly one place within the ranges of the new faces (V, unique
/// mapping), N.n > 0 there for every scan face around it, every scan edge can be followed across the walls (E) with
/// N.n > 0 at the crossings (X), the pillars inside scan triangles fit (P), the scan goes round once at kept vertices
/// (K), J > 0 on every new prismoid over its range (C0), and the images of a trimmed border do not meet on the patch
/// (T1); if asked for, every scan triangle keeps its orientation. All of it on the values as stored, decided exactly,
/// or refused. (Collins & Hilton 2002, section 5; Maggiordomo et al. 2023, section 5.2; docs/algorithm.md)
class Validator {
public:
    /// Refers to both.
    Validator(const BaseSurface& base, const PreparedScan& prepared, const ValidatorOptions& options);

    /// Judges the patch without touching anything. Time linear in the scan faces on the patch, for a bounded number of
    /// new faces.
    [[nodiscard]] Verdict judge(const Patch& patch);

    /// What the last patch would mean, if it was accepted. May be taken away.
    [[nodiscard]] Trial& trial() { return trial_; }

    /// Appends the base faces on which the verdict on the last patch rests besides those that it takes away: it stands
    /// as long as none of them changes.
    void append_read(std::vector<std::int32_t>& faces) const;

    /// Patches are asked first where the one before was refused. Verdicts do not depend on it, but which of several
    /// reasons is found first does.
    void forget_refusals();

    /// The scan faces that the last call to gather() found on the faces that go.
    [[nodiscard]] const std::vector<std::int32_t>& gather(const std::vector<std::int32_t>& removed);

private:
    void reset(const Patch& patch);
    [[nodiscard]] Verdict judge_reset(const Patch& patch);
    [[nodiscard]] Verdict judge_vertices(const Patch& patch);
    [[nodiscard]] Verdict judge_faces(const Patch& patch);
    [[nodiscard]] Verdict ask_witness();
    [[nodiscard]] Verdict locate_vertices(const Patch& patch);
    [[nodiscard]] std::size_t vertices_on(const Patch& patch) const;
    [[nodiscard]] Verdict locate_soon(std::int32_t v);
    [[nodiscard]] Verdict locate_pending();
    // Of the pending vertex with this index.
    [[nodiscard]] Verdict locate_vertex(int index);
    void solve_pending();
    [[nodiscard]] Verdict find_place(int index, Lift& lift);
    [[nodiscard]] Verdict test_normals_at(std::int32_t v, const Lift& lift) const;
    [[nodiscard]] Verdict reach_kept_corners();
    void find_wall_planes();
    void find_cone();
    [[nodiscard]] Verdict test_faces();
    [[nodiscard]] Verdict test_face(std::int32_t scan_face);
    [[nodiscard]] Verdict test_inside(std::int32_t scan_face, const std::array<std::int32_t, 3>& moved);
    [[nodiscard]] bool is_inside_one_cell(const std::array<std::int32_t, 3>& moved) const;
    [[nodiscard]] Verdict test_constant(std::int32_t scan_face, const std::array<Corner, 3>& corners);
    [[nodiscard]] Verdict test_orientation(int cell, const std::array<Corner, 3>& corners) const;
    [[nodiscard]] DisplacedPoint displaced(int cell, const Corner& corner) const;
    [[nodiscard]] Verdict record(std::int32_t scan_face, const ScanTriangle& q, const std::array<Corner, 3>& corners);
    [[nodiscard]] Verdict test_spanning(const ScanTriangle& q, const std::array<Corner, 3>& corners,
                                        const ScanNormal& normal);
    [[nodiscard]] Verdict test_kept_corners(const ScanTriangle& q, const std::array<Corner, 3>& corners,
                                            const ScanNormal& normal) const;
    [[nodiscard]] Verdict test_crossings(const ScanTriangle& q, const ScanNormal& normal) const;
    [[nodiscard]] Verdict test_pillars(const ScanTriangle& q, const std::array<Corner, 3>& corners);
    [[nodiscard]] Verdict close_ranges();
    [[nodiscard]] Verdict test_alternatives() const;
    [[nodiscard]] int common_cell(const std::array<Corner, 3>& corners) const;
    [[nodiscard]] Verdict stays_in(int cell, const std::array<Corner, 3>& corners) const;
    void touch(int cell, std::int32_t scan_face);
    void note_places();
    /// The cells between two scan edges that leave a kept vertex; false if one is impassable.
    [[nodiscard]] bool touch_between(const FanOrder& order, std::int32_t first, std::int32_t second,
                                     std::int32_t scan_face);

    const BaseSurface* base_;
    const PreparedScan* prepared_;
    const Scan* scan_;
    const ScanTopology* topology_;
    ValidatorOptions options_;

    PatchedSurface surface_;
    PointLocation location_;
    PatchRanges ranges_;
    PatchImage image_;
    PillarFlood flood_;
    FacesBeside beside_;
    TrimmedPatch borders_;
    Trial trial_;

    std::vector<std::int32_t> scan_faces_; ///< that were gathered
    Marks gathered_;                       ///< on each of them
    std::vector<Vec3> directions_;
    DirectionCone cone_{{}};         ///< of all directions of the new cells
    std::vector<WallPlanes> planes_; ///< of the new cells, over the displacements of the places on them
    std::vector<unsigned> behind_;   ///< for each of the new places, WallPlanes::behind()
    std::vector<std::pair<std::int32_t, Lift>> alternatives_;
    std::vector<std::int32_t> pending_; ///< scan vertices that are solved for together
    std::vector<Vec3> pending_points_;
    std::size_t most_pending_ = 0;
    std::int32_t witness_ = -1;      ///< the scan vertex for which the last patch was refused that was for one
    std::int32_t face_witness_ = -1; ///< the same for scan faces

    // Scratch of the scan face under test.
    std::vector<TraceCrossing> crossings_;
    OddEdges odd_;
    std::vector<std::int32_t> inside_; ///< base vertices
};

} // namespace foldless
