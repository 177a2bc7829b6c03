#include <foldless/decimate/edge_trace.h>

namespace foldless {
namespace {

/// A scan edge crosses more walls than this only where base faces are far smaller than scan faces; giving up then
/// refuses.
constexpr int most_crossings = 200;

} // namespace

bool certainly_stays_in(const Cell& cell, const Vec3& e, Range range) {
    return cell.wall(0).is_passed_one_way(e, range) && cell.wall(1).is_passed_one_way(e, range) &&
           cell.wall(2).is_passed_one_way(e, range);
}

Verdict trace_edge(PatchedSurface& surface, const TraceEnd& a, const TraceEnd& b,
                   std::vector<TraceCrossing>& crossings) {
    const ScanLine line{a.point, b.point};
    TraceEnd here = a;
    for (int n = 0; n < most_crossings; ++n) {
        const Cell& cell = surface.cell(here.cell);
        const Passage passage = follow_line(cell.triangle, line, here.at, here.cell == b.cell ? &b.at : nullptr);
        if (passage.kind == Passage::Kind::ends) {
            return Verdict::accepted;
        }
        if (passage.kind != Passage::Kind::leaves) {
            return passage.kind == Passage::Kind::pillar ? Verdict::tie : Verdict::no_preimage;
        }
        const int next = surface.neighbour(here.cell, passage.wall);
        if (next == border || surface.cell(next).impassable) {
            return Verdict::no_preimage;
        }
        if (within(passage.t, cell.range) == Sign::negative ||
            within(passage.t, surface.cell(next).range) == Sign::negative) {
            return Verdict::out_of_range;
        }
        const std::array<std::int32_t, 2> edge{cell.corners[(passage.wall + 1) % 3],
                                               cell.corners[(passage.wall + 2) % 3]};
        crossings.push_back({here.cell, passage.wall, next, edge, passage.t, line});
        // The next cell runs along the edge from edge[1] to edge[0].
        const int entered_by = (surface.corner_of(next, edge[0]) + 1) % 3;
        here = {a.point, next, {passage.t, wall_bit(entered_by)}};
    }
    return Verdict::undecided;
}

} // namespace foldless
