/// \file
/// An edge collapse as a patch, and the guards that need no validator.
#pragma once

#include <foldless/decimate/base_surface.h>
#include <foldless/decimate/patch.h>
#include <foldless/decimate/verdict.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// A halfedge collapse: `gone` moves into `stays`.
///
///            l                       The faces around both vertices go; those that do not have both of them come
///          / | \                     back with `stays` in the place of `gone`. The faces (gone, stays, l) and
///     ... gone-stays ...             (stays, gone, r) vanish.
///          \ | /
///            r
struct Collapse {
    OpenMesh::HalfedgeHandle halfedge = OpenMesh::HalfedgeHandle(); ///< from gone to stays
    std::int32_t gone = -1;
    std::int32_t stays = -1;
};

/// What may move: a fixed vertex keeps its place for good.
enum class Mobility : unsigned char { free, fixed };

/// What a collapse must respect.
struct CollapseRules {
    std::span<const Mobility> mobility; ///< per base vertex
    int edge_valence_limit;             ///< val(a) + val(b) - 1 stays below it
    bool has_crowded_vertices = false;  ///< somewhere: nothing collapses next to one
};

/// A vertex with more edges than these is crowded: every question about the patches around it would look at all of its
/// faces, and the time for all of them would grow with the square of their number or faster.
inline constexpr int most_edges_at_a_vertex = 1000;

/// Chooses which end of the edge stays, a fixed one if there is one, and applies the guards of topology: `frozen`,
/// `boundary`, `valence`, `link_condition`, in this order.
[[nodiscard]] Verdict make_collapse(const BaseSurface& base, std::int32_t edge, const CollapseRules& rules,
                                    Collapse& out);

/// The same collapse with the ends exchanged.
[[nodiscard]] Collapse reversed(const BaseSurface& base, const Collapse& collapse);

/// How far a collapse changes the base mesh.
enum class Extent {
    star_of_gone, ///< the vertex that stays keeps its place and its direction
    both_stars,   ///< it moves or turns
    two_rings,    ///< so do the directions of its neighbours
};

/// Fills the faces of the patch: the stars of one or both ends, or also the faces around the vertices of the rim.
void fill_faces(const BaseSurface& base, const Collapse& collapse, Extent extent, Patch& patch);

/// Base vertices on the rim of the two stars, in ascending order.
void rim_of(const BaseSurface& base, const Collapse& collapse, std::vector<std::int32_t>& out);

/// Guards the new faces of the patch: `degenerate` without area, `flip` if one turns by more than a right angle against
/// the face that it takes over. Every face must take over one.
[[nodiscard]] Verdict guard_faces(const BaseSurface& base, const Patch& patch);

} // namespace foldless
