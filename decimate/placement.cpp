#include <foldless/decimate/placement.h>

#include <foldless/io/float32.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

Vec3 stored_position(const Vec3& position, bool float32) {
    return float32 ? to_float32(position) : position;
}

void add_moved(const PlacementContext& context, const Vec3& position, std::vector<Candidate>& out) {
    const Vec3 stored = stored_position(position, context.float32);
    out.push_back({stored, -1, context.quadric(stored - context.origin), false});
}

void add_end(const PlacementContext& context, std::int32_t v, bool keeps_direction, std::vector<Candidate>& out) {
    const Vec3 position = context.base->vertex(v).position;
    out.push_back({position, v, context.quadric(position - context.origin), keeps_direction});
}

/// The minimiser, if it is well determined and not further from the edge than the edge is long.
std::optional<Vec3> minimiser_near(const PlacementContext& context) {
    const Vec3 a = context.base->vertex(context.collapse.gone).position;
    const Vec3 b = context.base->vertex(context.collapse.stays).position;
    const std::optional<Vec3> x = context.quadric.minimiser();
    if (!x) {
        return std::nullopt;
    }
    const Vec3 position = *x + context.origin;
    return (position - (a + b) / 2).norm() <= (b - a).norm() ? std::optional<Vec3>(position) : std::nullopt;
}

/// The midpoint of the edge, moved a little towards the third corner of one of its faces: the pillar of a vertex
/// exactly on a scan edge would pass through that edge, a tie that no arithmetic decides.
Vec3 beside_midpoint(const PlacementContext& context) {
    constexpr double share = 1.0 / 64; // of the way to that corner: far more than rounding, too little to matter
    const Collapse& collapse = context.collapse;
    const Connectivity& mesh = context.base->connectivity();
    auto side = mesh.next_halfedge_handle(collapse.halfedge);
    if (mesh.is_boundary(collapse.halfedge)) {
        side = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(collapse.halfedge));
    }
    const Vec3 third = context.base->vertex(mesh.to_vertex_handle(side).idx()).position;
    const Vec3 midpoint =
        (context.base->vertex(collapse.gone).position + context.base->vertex(collapse.stays).position) / 2;
    return midpoint + share * (third - midpoint);
}

/// A half-space n.x >= level, n of unit length.
struct HalfSpace {
    Vec3 n;
    double level;
};

/// The half-space beyond the border edge from `from` to `to` of the base mesh, the surface on its left.
std::optional<HalfSpace> beyond(const Vec3& from, const Vec3& to, const Vec3& direction) {
    const Vec3 outwards = (to - from).cross(direction);
    const double length = outwards.norm();
    if (!(length > 0)) {
        return std::nullopt;
    }
    // Beyond by a small share of the edge, so that the scan's border does not lie exactly on the new one.
    constexpr double share = 1.0 / 32;
    const Vec3 n = outwards / length;
    return HalfSpace{n, n.dot(from) + share * (to - from).norm()};
}

/// For a border edge: a point near its middle that leaves the border edges before, on and after it behind the new
/// border,
///
///      p ---- c ---- s        so that the base mesh reaches beyond the scan everywhere.
///       `a--------b'          (The surface is below.)
///
/// found by projecting on the violated half-spaces in turn.
std::optional<Vec3> covering_point(const PlacementContext& context) {
    const BaseSurface& base = *context.base;
    const Connectivity& mesh = base.connectivity();
    auto h = context.collapse.halfedge;
    if (!mesh.is_boundary(h)) {
        h = mesh.opposite_halfedge_handle(h);
    }
    // The border halfedge runs with the surface on its right.
    std::array<HalfSpace, 3> spaces;
    int count = 0;
    for (const auto edge : {mesh.prev_halfedge_handle(h), h, mesh.next_halfedge_handle(h)}) {
        const BaseVertex to = base.vertex(mesh.from_vertex_handle(edge).idx());
        const BaseVertex from = base.vertex(mesh.to_vertex_handle(edge).idx());
        const std::optional<HalfSpace> space = beyond(from.position, to.position, from.direction + to.direction);
        if (!space) {
            return std::nullopt;
        }
        spaces[count++] = *space;
    }
    constexpr int rounds = 30;
    const Vec3 middle =
        (base.vertex(context.collapse.gone).position + base.vertex(context.collapse.stays).position) / 2;
    Vec3 c = middle;
    for (int round = 0; round < rounds; ++round) {
        for (const HalfSpace& space : spaces) {
            c += std::max(0.0, space.level - space.n.dot(c)) * space.n;
        }
    }
    return c;
}

void add_covering(const PlacementContext& context, std::vector<Candidate>& out) {
    const std::optional<Vec3> c = covering_point(context);
    if (c) {
        add_moved(context, *c, out);
    }
}

} // namespace

void candidates(const PlacementContext& context, Placement placement, std::vector<Candidate>& out) {
    out.clear();
    const Collapse& collapse = context.collapse;
    if (context.stays_is_fixed) {
        if (context.keep_direction) {
            add_end(context, collapse.stays, true, out);
        }
        add_end(context, collapse.stays, false, out);
        return;
    }
    if (context.base->connectivity().is_boundary(context.base->connectivity().edge_handle(collapse.halfedge))) {
        add_covering(context, out);
    }
    const Vec3 midpoint = beside_midpoint(context);
    if (placement == Placement::midpoint) {
        add_moved(context, midpoint, out);
        return;
    }
    const std::optional<Vec3> minimiser = minimiser_near(context);
    if (placement == Placement::quadric) {
        add_moved(context, minimiser.value_or(midpoint), out);
        return;
    }
    if (context.keep_direction) {
        add_end(context, collapse.stays, true, out);
        add_end(context, collapse.gone, true, out);
    }
    add_end(context, collapse.stays, false, out);
    add_end(context, collapse.gone, false, out);
    if (placement == Placement::best) {
        add_moved(context, midpoint, out);
        if (minimiser) {
            add_moved(context, *minimiser, out);
        }
    }
    // The covering point of a border edge stays first: the others leave part of the scan uncovered more often than not.
    const auto first = out.begin() + (out.front().at < 0 ? 1 : 0);
    const double good_enough = context.good_enough * context.quadric.weight();
    const auto goes_first = [&](const Candidate& c) { return c.keeps_direction && c.error <= good_enough; };
    std::stable_sort(first, out.end(), [&](const Candidate& a, const Candidate& b) {
        return goes_first(a) != goes_first(b) ? goes_first(a) : a.error < b.error;
    });
}

} // namespace foldless
