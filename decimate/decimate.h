/// \file
/// Decimation of a scan into a base mesh that a scalar displacement map can turn back into the scan.
#pragma once

#include <foldless/decimate/verdict.h>
#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace foldless {

enum class Directions {
    visible, ///< maximises the smallest dot product with the normals of the scan faces that it must see
    area,    ///< area-weighted vertex normal of the base mesh
    angle,   ///< angle-weighted vertex normal of the base mesh
    face,    ///< constant over each face: its normal
};

enum class Placement {
    best,     ///< the quadric minimiser, the midpoint and both ends, in order of promise; the first valid one
    endpoint, ///< both ends
    midpoint,
    quadric,
};

enum class Boundary {
    lock, ///< the scan's border is the base's border, edge for edge
    trim, ///< the scan maps one-to-one into the base mesh, which may reach beyond the scan's border
};

/// How far a decimation has come.
struct Progress {
    std::size_t faces;  ///< faces of the base mesh now
    std::size_t target; ///< faces asked for; 0 when no target was given
    std::size_t input_faces;
};

struct DecimateOptions {
    std::optional<std::size_t> target_faces; ///< no value: go on until every edge is refused
    Directions directions = Directions::visible;
    bool store_directions = true; ///< false: directions of the one-ring are recomputed after each collapse
    Placement placement = Placement::best;
    bool unique_among_fold_free =
        false;                     ///< a second inverse displacement with J > 0 refuses at any t, not only in range
    bool orientation_test = false; ///< also ask Maggiordomo et al. 2023, section 5.2: sufficient conditions do without
    Boundary boundary = Boundary::lock;
    std::optional<double> max_displacement;        ///< bound on |t| |d| over whole faces, model units; no value: none
    int edge_valence_limit = 20;                   ///< val(a) + val(b) - 1 of a collapsed edge stays below this
    std::optional<double> time_limit;              ///< seconds; no value: none
    std::optional<int> threads;                    ///< no value: all cores
    std::function<bool(const Progress&)> progress; ///< called now and then; false asks to stop
};

/// The options of the preset `paper` (Collins & Hilton 2002): area-weighted normals recomputed over the one-ring,
/// midpoints, no choice of placement.
[[nodiscard]] DecimateOptions paper_options();

enum class StopReason { target_reached, every_edge_refused, time_limit, cancelled };

struct DecimateStatistics {
    std::size_t attempted = 0; ///< edges asked
    std::size_t accepted = 0;  ///< edges collapsed
    VerdictCounts refused{};   ///< asked placements refused, by verdict
    /// Of these, the placements on which every scan vertex has one place with N.n > 0, as Collins & Hilton 2002 ask,
    /// and which the certificate refuses for what is between the vertices. (Not counted: `orientation`.)
    std::size_t refused_between_vertices = 0;
    std::size_t unserved_vertices = 0; ///< scan vertices that no direction serves
    std::size_t retested_vertices = 0; ///< inversions asked of the validator, over all trials
    double setup_seconds = 0.0;
    double decimate_seconds = 0.0;
    double setup_cpu_seconds = 0.0;
    double decimate_cpu_seconds = 0.0;
};

struct DecimateResult {
    BaseMesh base;
    Correspondence correspondence;
    StopReason stop_reason = StopReason::every_edge_refused;
    DecimateStatistics statistics;
};

/// Collapses edges of `scan`, shortest first, as long as the base mesh represents the scan.
///
/// The result is a valid base mesh whenever the call returns: every state is valid by construction, so a time limit or
/// a cancelled progress callback costs nothing but reduction. Deterministic: the result depends on the scan and on the
/// options other than `threads`, `time_limit` and `progress`; on the numbering of the scan only where two vertices have
/// the same position.
///
/// Several calls may run at once, on threads of the caller or inside loops of TBB. What the progress callback throws
/// comes out of the call.
///
/// \throws RefusedMesh if `scan` has a defect (see io/defects.h).
/// \throws std::invalid_argument for less than one thread, or a time limit or bound that is negative or no number.
/// Time O(n log n) in practice; see docs/results.md. (Collins & Hilton 2002, section 5)
[[nodiscard]] DecimateResult decimate(const Scan& scan, const DecimateOptions& options = {});

/// The same without a copy of the scan, which takes 24 bytes per face. While the call runs, the scan's vertices and
/// faces are in another order, and nobody else may use it. Afterwards it is as it was; if something is thrown, it is
/// the same surface in an unspecified order.
[[nodiscard]] DecimateResult decimate_in_place(Scan& scan, const DecimateOptions& options = {});

} // namespace foldless
