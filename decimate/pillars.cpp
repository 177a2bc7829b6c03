#include <foldless/decimate/pillars.h>

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/scan_normal.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

std::pair<std::int32_t, std::int32_t> ordered(std::int32_t a, std::int32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Does the pillar of the base vertex pass through the inside of the scan triangle with N.n > 0? Positive: yes;
/// negative: no; zero: through its border. Exactly.
Sign pierces(const BaseVertex& vertex, const ScanTriangle& q) {
    if (seen_along(vertex.direction, q) != Sign::positive) {
        return Sign::negative;
    }
    // Seen along the direction, the triangle is counter-clockwise; the pillar is a point, to the left of all edges.
    Sign result = Sign::positive;
    for (int k = 0; k < 3; ++k) {
        const Sign side = seen_along(vertex.direction, {q[k], q[(k + 1) % 3], vertex.position});
        if (side == Sign::negative) {
            return Sign::negative;
        }
        if (side != Sign::positive) {
            result = Sign::zero;
        }
    }
    return result;
}

/// Displacement at which the pillar meets the plane of the triangle: t = -l/m with l = (v - q0).n and m = d.n.
Pillar pillar_at(std::int32_t index, const BaseVertex& vertex, const ScanTriangle& q) {
    const ScanNormal n(q);
    const Vec3 offset = vertex.position - q[0];
    const double l = offset.dot(n.value());
    const double m = vertex.direction.dot(n.value());
    const double l_error = 2 * n.error(offset); // twice: the offset is itself rounded
    const double m_error = n.error(vertex.direction);
    const double t = -l / m;
    const double t_error =
        (l_error + std::abs(t) * m_error) / (std::abs(m) - m_error) + 2 * unit_roundoff * std::abs(t);
    return {index, t, t_error};
}

bool contains(const std::vector<Pillar>& pillars, std::int32_t vertex) {
    return std::any_of(pillars.begin(), pillars.end(), [&](const Pillar& p) { return p.vertex == vertex; });
}

} // namespace

void OddEdges::toggle(std::int32_t a, std::int32_t b) {
    const auto edge = ordered(a, b);
    const auto found = std::find(edges_.begin(), edges_.end(), edge);
    if (found == edges_.end()) {
        edges_.push_back(edge);
    } else {
        edges_.erase(found);
    }
}

bool OddEdges::contains(std::int32_t a, std::int32_t b) const {
    return std::find(edges_.begin(), edges_.end(), ordered(a, b)) != edges_.end();
}

Verdict PillarFlood::find(PatchedSurface& surface, const ScanTriangle& triangle, const OddEdges& odd,
                          std::vector<Pillar>& inside) {
    inside.clear();
    outside_.clear();
    odd_met_ = 0;
    for (const auto& edge : odd.values()) {
        for (const std::int32_t v : {edge.first, edge.second}) {
            if (contains(inside, v) || std::find(outside_.begin(), outside_.end(), v) != outside_.end()) {
                continue;
            }
            const BaseVertex& vertex = surface.vertex(v);
            const Sign sign = vertex.scan_vertex >= 0 ? Sign::negative : pierces(vertex, triangle);
            if (sign == Sign::zero) {
                return Verdict::tie;
            }
            if (sign == Sign::positive) {
                inside.push_back(pillar_at(v, vertex, triangle));
            } else {
                outside_.push_back(v);
            }
        }
    }
    const Verdict verdict = spread(surface, triangle, odd, inside);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    // Every odd edge was met from its one end inside.
    return odd_met_ == odd.size() ? Verdict::accepted : Verdict::normal_condition;
}

Verdict PillarFlood::spread(PatchedSurface& surface, const ScanTriangle& triangle, const OddEdges& odd,
                            std::vector<Pillar>& inside) {
    Verdict verdict = Verdict::accepted;
    for (std::size_t next = 0; verdict == Verdict::accepted && next < inside.size(); ++next) {
        const std::int32_t v = inside[next].vertex;
        const Fan& fan = surface.fan(v);
        const auto impassable = [&](int c) { return surface.cell(c).impassable; };
        if (!fan.closed || std::any_of(fan.cells.begin(), fan.cells.end(), impassable)) {
            return Verdict::normal_condition;
        }
        for (std::size_t n = 0; verdict == Verdict::accepted && n < fan.spokes.size(); ++n) {
            const std::int32_t spoke = fan.spokes[n];
            const bool is_odd = odd.contains(v, spoke);
            odd_met_ += is_odd ? 1 : 0;
            if (contains(inside, spoke)) {
                verdict = is_odd ? Verdict::normal_condition : Verdict::accepted;
            } else if (!is_odd) {
                verdict = enter(surface, triangle, spoke, inside);
            }
        }
    }
    return verdict;
}

Verdict PillarFlood::enter(const PatchedSurface& surface, const ScanTriangle& triangle, std::int32_t spoke,
                           std::vector<Pillar>& inside) {
    const BaseVertex& vertex = surface.vertex(spoke);
    const Sign sign = vertex.scan_vertex >= 0 ? Sign::negative : pierces(vertex, triangle);
    if (sign != Sign::positive) {
        return sign == Sign::zero ? Verdict::tie : Verdict::normal_condition;
    }
    inside.push_back(pillar_at(spoke, vertex, triangle));
    return Verdict::accepted;
}

} // namespace foldless
