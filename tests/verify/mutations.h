/// \file
/// Base meshes of scans, and ways to spoil them.
#pragma once

#include "made_meshes.h"
#include "random_scans.h"

#include <string_view>

namespace foldless::test {

enum class Mutation {
    none,
    direction_flipped, ///< of a base vertex
    direction_bent,    ///< the same, by less than a right angle
    base_vertices_swapped,
    scan_vertices_swapped, ///< the two ends of an edge
    base_vertex_moved,     ///< by 5 % of the diagonal of the scan
    scan_vertex_moved,
    range_cut,               ///< to a part of it
    range_widened,           ///< to several times its size
    scan_vertex_pushed,      ///< through its neighbours, along an edge
    scan_vertex_half_pushed, ///< over about the middle of an edge
    hole,                    ///< the star of a vertex is left out, or one face
    unguarded,               ///< the base mesh collapses further, with no test of the displacement map
    by_openmesh,             ///< another base mesh of as many faces, which OpenMesh makes of the scan
    by_cgal,                 ///< the same by CGAL
};

inline constexpr int mutation_count = static_cast<int>(Mutation::by_cgal) + 1;

[[nodiscard]] std::string_view name(Mutation mutation);

/// A small scan, closed or with a locked border, and what decimate() makes of it under a random target.
[[nodiscard]] Pair random_pair(Random& random);

/// The pair with one thing changed.
[[nodiscard]] Pair mutated(const Pair& pair, Mutation mutation, Random& random);

} // namespace foldless::test
