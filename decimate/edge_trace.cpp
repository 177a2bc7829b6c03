#include <foldless/decimate/edge_trace.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// A scan edge crosses more walls than this only where base faces are far smaller than scan faces; giving up then
/// refuses.
constexpr int most_crossings = 200;

Range hull(double a, double b) {
    return {std::min(a, b), std::max(a, b)};
}

bool holds(Range outer, Range inner) {
    return outer.lo <= inner.lo && inner.hi <= outer.hi;
}

/// The edge where it enters a cell.
struct Visit {
    Vec3 a, e; ///< start of the edge, and from there to its end
    double s;  ///< how far along the edge
    double s_error;
    int entered_by;  ///< the wall through which it came, or -1
    Passing passing; ///< of the walls, at the displacements where it is likely to leave
};

/// A crossing through which the edge leaves a cell.
struct Exit {
    int wall = -1;
    Wall::Crossing at{};
};

/// The first wall through which the edge leaves the cell at a displacement in `range`, not further back than s.
Exit first_exit(const Cell& cell, const Visit& visit, Range range) {
    Exit exit;
    const bool known = holds(visit.passing.range, range);
    for (int k = 0; k < 3; ++k) {
        if (known && visit.passing.sign[k] == Sign::negative) {
            continue;
        }
        const Wall::Crossings found = cell.wall(k).crossings(visit.a, visit.e, {range, true});
        for (int n = 0; n < found.count; ++n) {
            const Wall::Crossing& at = found.values[n];
            // A curved wall may be crossed again on the way out; where the edge came in is no exit.
            const bool ahead =
                k == visit.entered_by ? at.s > visit.s + visit.s_error + at.error : at.s >= visit.s - at.error;
            const bool in_range = at.t >= cell.range.lo && at.t <= cell.range.hi;
            const bool outwards = std::isinf(at.error) || cell.wall(k).passes_at(visit.e, at) == Sign::positive;
            if (ahead && in_range && outwards && (exit.wall < 0 || at.s < exit.at.s)) {
                exit = {k, at};
            }
        }
    }
    return exit;
}

/// The first exit at a likely displacement, else at any.
Exit find_exit(const Cell& cell, const Visit& visit) {
    const Range likely{std::max(cell.range.lo, visit.passing.range.lo),
                       std::min(cell.range.hi, visit.passing.range.hi)};
    const Exit exit = first_exit(cell, visit, likely);
    return exit.wall < 0 ? first_exit(cell, visit, cell.range) : exit;
}

bool strictly_inside_unit(double value, double error) {
    return value > error && value < 1 - error;
}

/// Whether wall k of the cell ends at a kept end of the stretch and is met only there.
bool met_only_at_end(const PatchedSurface& surface, int cell, int k, const Stretch& stretch) {
    for (const std::int32_t v : stretch.kept) {
        const int corner = v < 0 ? -1 : surface.corner_of(cell, v);
        if (corner >= 0 && corner != k) {
            const int lambda = corner == (k + 1) % 3 ? 0 : 1;
            if (surface.cell(cell).wall(k).met_only_at_corner(stretch.e, lambda, stretch.range)) {
                return true;
            }
        }
    }
    return false;
}

/// Whether every crossing of the line with the wall lies outside the stretch; one at an end is that end itself.
bool crosses_elsewhere(const Wall& wall, const Stretch& stretch) {
    const Wall::Crossings found = wall.crossings(stretch.a, stretch.e, {stretch.range, false});
    for (int n = 0; n < found.count; ++n) {
        const Wall::Crossing& at = found.values[n];
        const double slack = at.error + stretch.s_error;
        const bool between = at.s > stretch.s[0] + slack && at.s < stretch.s[1] - slack;
        const bool in_range = at.t >= stretch.range.lo - at.t_error && at.t <= stretch.range.hi + at.t_error;
        if ((between && in_range) || std::isinf(at.error)) {
            return false;
        }
    }
    return true;
}

/// Whether the edge, on its way out through the wall that the stretch names, certainly meets that wall nowhere before.
bool leaves_once(const PatchedSurface& surface, int c, const Stretch& way, const Passing& known) {
    const Cell& cell = surface.cell(c);
    const int k = way.exit;
    // At a kept corner of the wall the line meets it, too: then the quadratic whose roots these are has no third.
    const int corner = way.kept[0] < 0 ? -1 : surface.corner_of(c, way.kept[0]);
    const bool starts_on_wall = corner >= 0 && corner != k;
    return starts_on_wall || (known.sign[k] == Sign::positive && holds(known.range, way.range)) ||
           cell.wall(k).passes(way.e, way.range) == Sign::positive ||
           cell.wall(k).meets_once_at_most(way.a, way.e, way.range) || crosses_elsewhere(cell.wall(k), way);
}

} // namespace

Passing passing(const Cell& cell, const Vec3& e, Range range) {
    return {range, {cell.wall(0).passes(e, range), cell.wall(1).passes(e, range), cell.wall(2).passes(e, range)}};
}

bool meets_no_wall(const PatchedSurface& surface, int cell, const Stretch& stretch, const Passing& known) {
    const Cell& c = surface.cell(cell);
    const bool applies = holds(known.range, stretch.range);
    for (int k = 0; k < 3; ++k) {
        if (k == stretch.exit || (applies && known.sign[k] != Sign::undecided)) {
            continue;
        }
        if (c.wall(k).passes(stretch.e, stretch.range) == Sign::undecided &&
            !c.wall(k).misses(stretch.a, stretch.e, stretch.range) && !met_only_at_end(surface, cell, k, stretch) &&
            !stays_off_wall(c.triangle, k, part_of_edge(stretch.a, stretch.e, stretch.s, stretch.s_error),
                            stretch.range) &&
            !crosses_elsewhere(c.wall(k), stretch)) {
            return false;
        }
    }
    return true;
}

Verdict trace_edge(PatchedSurface& surface, const TraceEnd& a, const TraceEnd& b,
                   std::vector<TraceCrossing>& crossings) {
    const Vec3 e = b.point - a.point;
    int at = a.cell;
    int entered_by = -1;
    double t = a.t;
    double s = 0;
    double s_error = 0;
    const double length = e.norm();
    for (int n = 0; n < most_crossings; ++n) {
        const std::int32_t from_kept = n == 0 ? a.kept : -1;
        // Directions of unit length move a point of the edge by no more than the base mesh is off, rarely by its
        // length.
        const Range towards{std::min(t, b.t) - length, std::max(t, b.t) + length};
        const Visit visit{a.point, e, s, s_error, entered_by, passing(surface.cell(at), e, towards)};
        if (at == b.cell) {
            const Stretch rest{a.point, e, {s, 1.0}, s_error, hull(t, b.t), {from_kept, b.kept}, -1};
            if (meets_no_wall(surface, at, rest, visit.passing)) {
                return Verdict::accepted;
            }
        }
        const Exit exit = find_exit(surface.cell(at), visit);
        if (exit.wall < 0) {
            return at == b.cell ? Verdict::undecided : Verdict::no_preimage;
        }
        const Cell& cell = surface.cell(at);
        const Range between = hull(t, exit.at.t);
        const Stretch way{a.point,         e,        {s, exit.at.s}, std::max(s_error, exit.at.error), between,
                          {from_kept, -1}, exit.wall};
        if (!strictly_inside_unit(exit.at.lambda, exit.at.error) || !leaves_once(surface, at, way, visit.passing) ||
            !meets_no_wall(surface, at, way, visit.passing)) {
            return Verdict::undecided;
        }
        const std::array<std::int32_t, 2> base_edge{cell.corners[(exit.wall + 1) % 3],
                                                    cell.corners[(exit.wall + 2) % 3]};
        const int next = surface.neighbour(at, exit.wall);
        if (next == border || surface.cell(next).impassable) {
            return Verdict::no_preimage;
        }
        crossings.push_back({at, next, base_edge, exit.at.lambda, exit.at.error, exit.at.t, exit.at.t_error});
        entered_by = surface.corner_of(next, base_edge[0]);
        entered_by = (entered_by + 1) % 3; // next runs along the edge from base_edge[1] to base_edge[0]
        at = next;
        t = exit.at.t;
        s = exit.at.s;
        s_error = exit.at.error;
    }
    return Verdict::undecided;
}

} // namespace foldless
