#include <foldless/decimate/pillars.h>

#include <foldless/predicates/pillar.h>

#include <algorithm>

namespace foldless {
namespace {

std::pair<std::int32_t, std::int32_t> ordered(std::int32_t a, std::int32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Does its pillar pass through the inside of the scan triangle with N.n > 0? Positive: yes; negative: no; zero:
/// through its border. A kept vertex is inside no scan triangle.
Sign is_inside(const BaseVertex& vertex, const ScanTriangle& triangle) {
    return vertex.scan_vertex >= 0 ? Sign::negative : pierces({vertex.position, vertex.direction}, triangle);
}

bool contains(const std::vector<std::int32_t>& vertices, std::int32_t vertex) {
    return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
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
                          std::vector<std::int32_t>& inside) {
    inside.clear();
    outside_.clear();
    odd_met_ = 0;
    for (const auto& edge : odd.values()) {
        for (const std::int32_t v : {edge.first, edge.second}) {
            if (contains(inside, v) || contains(outside_, v)) {
                continue;
            }
            const Sign sign = is_inside(surface.vertex(v), triangle);
            if (sign == Sign::zero) {
                return Verdict::tie;
            }
            if (sign == Sign::positive) {
                inside.push_back(v);
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
                            std::vector<std::int32_t>& inside) {
    Verdict verdict = Verdict::accepted;
    for (std::size_t next = 0; verdict == Verdict::accepted && next < inside.size(); ++next) {
        const std::int32_t v = inside[next];
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
                           std::vector<std::int32_t>& inside) {
    const Sign sign = is_inside(surface.vertex(spoke), triangle);
    if (sign != Sign::positive) {
        return sign == Sign::zero ? Verdict::tie : Verdict::normal_condition;
    }
    inside.push_back(spoke);
    return Verdict::accepted;
}

} // namespace foldless
