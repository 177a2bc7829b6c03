/// \file
/// The association: where every scan vertex lies on the base mesh.
#pragma once

#include <foldless/verify/findings.h>
#include <foldless/verify/locate.h>
#include <foldless/verify/stages.h>

#include <cstdint>
#include <vector>

namespace foldless::verification {

/// The place of every scan vertex.
struct Association {
    std::vector<Place> places;
    std::size_t ambiguous_vertices =
        0; ///< those that faces reach too which share no vertex with the face of their place
};

/// The association of every scan vertex that a moving scan face uses. Kept vertices lie at t = 0 at their base vertex;
/// of the others several places are resolved by continuity: the right one is that to which a scan edge leads from a
/// neighbour whose place is known. Violations: `no_preimage`; `several_preimages`, if another place is in a face that
/// shares a vertex with that of the right one; `undecided`.
class Associator {
public:
    Associator(const BaseFaces& base, const Meshes& meshes)
        : base_(base), scan_(meshes.scan), scan_adjacency_(meshes.scan_adjacency), kept_(meshes.kept), index_(base) {}

    /// Vertices that only frozen faces use have no place.
    [[nodiscard]] Association associate(Stages& stages, double share, Findings& findings) const;

private:
    [[nodiscard]] bool locate_vertex(std::int32_t vertex, Place& place, Findings& findings) const;
    [[nodiscard]] Place locate_kept(std::int32_t vertex, Findings& findings) const;
    [[nodiscard]] bool is_used(std::int32_t vertex) const;
    void resolve(std::vector<std::int32_t> open, Association& association) const;
    [[nodiscard]] bool has_another_nearby(std::int32_t vertex, const Place& place) const;
    void take_part(std::int32_t first, std::vector<bool>& waiting) const;
    [[nodiscard]] std::vector<std::int32_t> first_of_each_part(const std::vector<std::int32_t>& open) const;
    void break_deadlock(const std::vector<std::int32_t>& open, Association& association) const;
    [[nodiscard]] std::vector<std::int32_t> placed_neighbours(std::int32_t vertex,
                                                              const Association& association) const;
    [[nodiscard]] Place nearest(std::int32_t vertex) const;
    [[nodiscard]] Place continued(std::int32_t vertex, const Association& association) const;
    [[nodiscard]] Place reached_from(std::int32_t neighbour, std::int32_t vertex, const Association& association,
                                     const std::vector<Place>& candidates) const;

    const BaseFaces& base_;
    const Scan& scan_;
    const Adjacency& scan_adjacency_;
    const KeptVertices& kept_;
    PrismoidIndex index_;
};

} // namespace foldless::verification
