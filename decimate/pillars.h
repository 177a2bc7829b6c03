/// \file
/// Condition P: which base vertices lie inside the image of a scan triangle.
#pragma once

#include <foldless/decimate/edge_trace.h>
#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/vector.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace foldless {

/// Base edges that the boundary of a scan triangle crosses an odd number of times.
class OddEdges {
public:
    void clear() { edges_.clear(); }
    void toggle(std::int32_t a, std::int32_t b);
    [[nodiscard]] bool contains(std::int32_t a, std::int32_t b) const;
    [[nodiscard]] bool empty() const { return edges_.empty(); }
    [[nodiscard]] std::size_t size() const { return edges_.size(); }
    /// The two base vertices of each edge, smaller index first.
    [[nodiscard]] const std::vector<std::pair<std::int32_t, std::int32_t>>& values() const { return edges_; }

private:
    std::vector<std::pair<std::int32_t, std::int32_t>> edges_;
};

/// Finds the set I of base vertices inside the image of the triangle, by flooding from the odd edges: exactly one end
/// of an odd edge is inside, both or neither of an even one; every vertex inside must be pierced with N.n > 0. Appends
/// them. Fails with `normal_condition` when the parities do not fit, `tie` if a pillar passes through the border of the
/// triangle. Decided exactly.
class PillarFlood {
public:
    [[nodiscard]] Verdict find(PatchedSurface& surface, const ScanTriangle& triangle, const OddEdges& odd,
                               std::vector<std::int32_t>& inside);

private:
    [[nodiscard]] Verdict spread(PatchedSurface& surface, const ScanTriangle& triangle, const OddEdges& odd,
                                 std::vector<std::int32_t>& inside);
    /// Adds a vertex that must be inside, as an even edge leads there from one that is.
    [[nodiscard]] static Verdict enter(const PatchedSurface& surface, const ScanTriangle& triangle, std::int32_t spoke,
                                       std::vector<std::int32_t>& inside);

    std::vector<std::int32_t> outside_;
    std::size_t odd_met_ = 0;
};

} // namespace foldless
