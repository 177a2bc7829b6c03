/// \file
/// Finer spheres from coarse ones.
#pragma once

#include <foldless/io/scan.h>

#include <algorithm>
#include <map>
#include <utility>

namespace foldless::test {

/// Splits every triangle in four at the midpoints of its edges, moved to the unit sphere.
inline Scan subdivided(const Scan& mesh) {
    Scan result{mesh.positions, {}, mesh.float32};
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> midpoints;
    const auto midpoint = [&](std::int32_t a, std::int32_t b) {
        const auto next = static_cast<std::int32_t>(result.positions.size());
        const auto [entry, is_new] = midpoints.try_emplace({std::min(a, b), std::max(a, b)}, next);
        if (is_new) {
            result.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
        }
        return entry->second;
    };
    for (const auto& [a, b, c] : mesh.faces) {
        const std::int32_t ab = midpoint(a, b);
        const std::int32_t bc = midpoint(b, c);
        const std::int32_t ca = midpoint(c, a);
        result.faces.insert(result.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return result;
}

} // namespace foldless::test
