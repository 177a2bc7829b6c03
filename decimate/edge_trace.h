/// \file
/// Condition E: following an edge of the scan from the place of one end to that of the other, across the walls of the
/// base mesh.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/verdict.h>

#include <foldless/predicates/prismoid_line.h>

#include <array>
#include <vector>

namespace foldless {

/// One end of a scan edge: a point, and where it lies.
struct TraceEnd {
    const Vec3* point;
    int cell; ///< for a kept vertex, the cell in which the edge starts
    PrismoidPoint at;
};

/// A crossing of a scan edge with the wall between two cells.
struct TraceCrossing {
    int from;                         ///< the cell that is left
    int wall;                         ///< through its wall opposite this corner
    int to;                           ///< the cell that is entered
    std::array<std::int32_t, 2> edge; ///< base vertices of the wall
    Displacement t;
    ScanLine line; ///< the edge
};

/// Whether an edge along e whose ends lie in the cell, at displacements within the range, certainly stays in it: every
/// wall is passed in one direction only. What the test leaves open is for trace_edge().
[[nodiscard]] bool certainly_stays_in(const Cell& cell, const Vec3& e, Range range);

/// Follows the edge and appends its crossings in order. `no_preimage` if it leaves through a border, into an impassable
/// cell, or elsewhere than to its end; `out_of_range` if it crosses a wall outside the range of a cell there; `tie` if
/// it passes a pillar; `undecided` if it passes too many walls. Exact; J > 0 is relied on in the new cells, within the
/// displacements that are met.
[[nodiscard]] Verdict trace_edge(PatchedSurface& surface, const TraceEnd& a, const TraceEnd& b,
                                 std::vector<TraceCrossing>& crossings);

} // namespace foldless
