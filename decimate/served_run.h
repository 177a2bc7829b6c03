/// \file
/// At a vertex that no direction serves: the faces that one direction can see.
#pragma once

#include <foldless/predicates/vector.h>

#include <cstddef>
#include <span>

namespace foldless {

/// Consecutive faces around a vertex, and the direction that sees them best.
struct ServedRun {
    std::size_t first;
    std::size_t count;
    Vec3 direction;

    /// Whether it holds face i of n.
    [[nodiscard]] bool contains(std::size_t i, std::size_t n) const { return (i + n - first) % n < count; }
};

/// The longest run of faces around a vertex, given by their unit normals in order, that one direction sees; the first
/// of several. It goes on from the last face to the first if the faces close up. O(n) calls of
/// most_visible_direction(). \pre there is a normal
[[nodiscard]] ServedRun longest_served_run(std::span<const Vec3> unit_normals, bool closed);

} // namespace foldless
