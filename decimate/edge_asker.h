/// \file
/// Whether an edge may be collapsed, and how.
#pragma once

#include <foldless/decimate/base_surface.h>
#include <foldless/decimate/collapse.h>
#include <foldless/decimate/decimate.h>
#include <foldless/decimate/placement.h>
#include <foldless/decimate/prepared_scan.h>
#include <foldless/decimate/quadric.h>
#include <foldless/decimate/trial.h>
#include <foldless/decimate/validator.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace foldless {

/// What an edge is asked about; it changes between questions only. Refers to all of it.
struct AskedState {
    const PreparedScan* scan;
    const BaseSurface* base;
    const std::vector<Mobility>* mobility; ///< per base vertex
    const VertexQuadrics* quadrics;
    const DecimateOptions* options;
    Vec3 origin;               ///< of the quadrics
    double good_enough;        ///< squared distance up to which an end that keeps its direction goes before all else
    bool has_crowded_vertices; ///< see CollapseRules
};

/// What the loop may do with an edge, and what it counts.
struct EdgeAnswer {
    bool accepted = false;
    Collapse collapse; ///< this and the next three: how, if accepted
    Extent extent = Extent::both_stars;
    Patch patch;
    Trial trial;
    VerdictCounts refused{}; ///< of the edge, or of its placements
    std::size_t refused_between_vertices = 0;
    std::size_t retested_vertices = 0;
    /// The base faces on which it rests, some more than once. It stands as long as no patch takes one of them away:
    /// what is known of a vertex changes only together with a face around it, and whose neighbour a face is with that.
    std::vector<std::int32_t> read;
};

/// Asks edges one at a time. The answer depends on the state alone, not on what was asked before: it may be given ahead
/// of time, and by any thread that has an asker of its own.
class EdgeAsker {
public:
    explicit EdgeAsker(const AskedState& state);

    /// Asks the placements of the policy in order of promise, until one is accepted. Touches nothing but `answer`.
    void ask(std::int32_t edge, EdgeAnswer& answer);

private:
    [[nodiscard]] Verdict ask_candidates(std::int32_t edge);
    [[nodiscard]] Verdict ask_candidate(const Collapse& collapse, const Candidate& candidate);
    [[nodiscard]] Extent extent_of(const Candidate& candidate) const;
    void fill_patch(const Candidate& candidate);
    [[nodiscard]] bool set_directions();
    [[nodiscard]] std::optional<Vec3> direction_of(std::int32_t v);
    [[nodiscard]] std::optional<Vec3> star_normal(std::int32_t v);
    [[nodiscard]] std::optional<Vec3> visible_direction_of(std::int32_t v);
    [[nodiscard]] const std::optional<Vec3>& visible_direction_of_survivor();
    [[nodiscard]] bool is_frozen(std::int32_t face) const;
    void note_stars(const Collapse& collapse);

    AskedState state_;
    Validator validator_;
    EdgeAnswer* answer_ = nullptr; ///< to the question at hand

    bool survivor_is_known_ = false; ///< the following was computed for the edge at hand
    std::optional<Vec3> visible_from_survivor_;
    std::vector<Candidate> candidates_;
    std::vector<std::int32_t> rim_;
    std::vector<std::int32_t> star_faces_;
    std::vector<std::array<Vec3, 3>> star_;
    std::vector<Vec3> normals_;
};

/// The corners of a face, turned so that v comes first.
[[nodiscard]] std::array<Vec3, 3> from_corner(const Triangle& corners, const std::array<Vec3, 3>& positions,
                                              std::int32_t v);

} // namespace foldless
