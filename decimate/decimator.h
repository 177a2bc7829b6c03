/// \file
/// The decimation loop.
#pragma once

#include <foldless/decimate/base_surface.h>
#include <foldless/decimate/collapse.h>
#include <foldless/decimate/decimate.h>
#include <foldless/decimate/edge_queue.h>
#include <foldless/decimate/placement.h>
#include <foldless/decimate/quadric.h>
#include <foldless/decimate/scan_topology.h>
#include <foldless/decimate/validator.h>

#include <chrono>
#include <vector>

namespace foldless {

/// One decimation, from the scan as its own base mesh to the last collapse.
///
/// ask() computes and judges without touching anything; commit() is the only function that writes to the base mesh.
class Decimator {
public:
    /// Sets everything up: connectivity, directions, vertices that no direction serves, quadrics, the queue.
    Decimator(const Scan& scan, const DecimateOptions& options);

    /// Collapses until the target, the last edge, the time limit or the user stops it.
    [[nodiscard]] StopReason run();

    [[nodiscard]] const BaseSurface& base() const { return base_; }
    [[nodiscard]] const DecimateStatistics& statistics() const { return statistics_; }
    [[nodiscard]] std::size_t face_count() const { return face_count_; }

private:
    void find_directions();
    void freeze_unserved(const std::vector<char>& unserved);
    void freeze_faces_at(std::int32_t v, std::vector<char>& frozen);

    [[nodiscard]] bool ask(std::int32_t edge);
    [[nodiscard]] Extent extent_of(const Candidate& candidate) const;
    [[nodiscard]] Verdict ask_candidate(const Collapse& collapse, const Candidate& candidate);
    [[nodiscard]] bool set_directions(const Collapse& collapse);
    [[nodiscard]] std::optional<Vec3> direction_of(std::int32_t v);
    [[nodiscard]] std::optional<Vec3> visible_direction_of(std::int32_t v);
    [[nodiscard]] const std::optional<Vec3>& visible_direction_of_survivor();
    [[nodiscard]] bool is_frozen(std::int32_t face) const;
    void commit();
    [[nodiscard]] std::optional<StopReason> interrupted();

    const Scan* scan_;
    DecimateOptions options_;
    ScanTopology topology_;
    BaseSurface base_;
    Vec3 origin_;        ///< of the quadrics
    double good_enough_; ///< squared distance
    std::vector<Mobility> mobility_;
    bool has_crowded_vertices_;
    std::vector<Quadric> quadrics_;
    EdgeQueue queue_;
    Validator validator_;
    std::size_t face_count_;
    DecimateStatistics statistics_;
    std::chrono::steady_clock::time_point start_;
    std::size_t asked_since_check_ = 0;

    // The collapse under question; valid for commit() once ask() has said yes.
    Collapse collapse_;
    Extent extent_ = Extent::both_stars;
    Patch patch_;
    std::vector<Candidate> candidates_;
    bool survivor_is_known_ = false; ///< the following was computed for the edge under question
    std::optional<Vec3> visible_from_survivor_;
    std::vector<std::int32_t> rim_;
    std::vector<std::int32_t> star_faces_;
    std::vector<std::int32_t> edges_;
    std::vector<std::array<Vec3, 3>> star_;
    std::vector<Vec3> normals_;
};

} // namespace foldless
