/// \file
/// Condition E: following an edge of the scan from the place of one end to that of the other, across the walls of the
/// base mesh.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/verdict.h>

#include <array>
#include <vector>

namespace foldless {

/// One end of a scan edge: a point, and where it lies.
struct TraceEnd {
    Vec3 point;
    int cell; ///< for a kept vertex, the cell in which the edge starts
    double t;
    std::int32_t kept; ///< the base vertex that it is kept as, or -1
};

/// A stretch of a scan edge with both ends in one cell.
struct Stretch {
    Vec3 a;                                   ///< start of the edge
    Vec3 e;                                   ///< from its start to its end
    std::array<double, 2> s;                  ///< the ends of the stretch, 0 at the start of the edge, 1 at its end
    double s_error;                           ///< bound on their errors
    Range range;                              ///< hull of the displacements of its ends
    std::array<std::int32_t, 2> kept{-1, -1}; ///< base vertices that its ends are kept as, or -1
    int exit = -1;                            ///< the wall through which it leaves, which is not asked
};

/// The direction in which a scan edge along `e` passes each wall of a cell over a range of displacements, as
/// Wall::passes() has it.
struct Passing {
    Range range;
    std::array<Sign, 3> sign;
};
[[nodiscard]] Passing passing(const Cell& cell, const Vec3& e, Range range);

/// Whether the stretch certainly meets no wall of the cell between its ends: every wall is either passed in one
/// direction only over its displacements, hence at most once, which two ends on the inner side exclude; or it starts
/// from an end of the stretch and is met only there; or the line of the edge misses it; or the stretch stays on one
/// side of it; or its crossings, all known, lie elsewhere. Cheapest first, what is known already before all.
[[nodiscard]] bool meets_no_wall(const PatchedSurface& surface, int cell, const Stretch& stretch, const Passing& known);

/// A crossing of a scan edge with the wall between two cells.
struct TraceCrossing {
    int from, to;                     ///< cells
    std::array<std::int32_t, 2> edge; ///< base vertices of the wall
    double lambda;                    ///< 0 at edge[0], 1 at edge[1]
    double lambda_error;
    double t, t_error;
};

/// Follows the edge and appends its crossings in order. `no_preimage` if it leaves through a border or into an
/// impassable cell, `undecided` if its way cannot be proven.
///
/// Within a cell, the way from one point to the next stays inside if every wall is passed in one direction only over
/// the displacements between them: then it meets each wall at most once, and both ends are on its inner side. The
/// displacement is monotone on the way (docs/certificate.md).
[[nodiscard]] Verdict trace_edge(PatchedSurface& surface, const TraceEnd& a, const TraceEnd& b,
                                 std::vector<TraceCrossing>& crossings);

} // namespace foldless
