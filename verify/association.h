/// \file
/// The association: where every scan vertex lies on the base mesh.
#pragma once

#include <foldless/verify/edge_trace.h>
#include <foldless/verify/findings.h>
#include <foldless/verify/locate.h>
#include <foldless/verify/pillar_star.h>
#include <foldless/verify/stages.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace foldless::verification {

/// The place of every scan vertex that a moving scan face uses: one lift of the scan's vertices.
class Association {
public:
    Association(const BaseFaces& base, const Meshes& meshes);

    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] const Place& place(std::int32_t vertex) const { return places_[vertex]; }
    [[nodiscard]] bool has_place(std::int32_t vertex) const { return places_[vertex].exists(); }
    /// The order of the scan edges around a vertex on a pillar, or null.
    [[nodiscard]] const PillarStar* star(std::int32_t vertex) const;

    /// Gives the vertex its place. With vertex directions a vertex on a pillar must satisfy K: false, and it has no
    /// place, if it does not.
    bool set(std::int32_t vertex, const Place& place);

    /// Whether both ends are kept and the scan edge between them is a base edge: it represents itself.
    [[nodiscard]] bool is_base_edge(std::int32_t a, std::int32_t b) const;
    /// Where the scan edge from a to b starts. \pre a has a place, and the edge is no base edge
    [[nodiscard]] FacePosition start(std::int32_t a, std::int32_t b) const;
    /// Follows the scan edge from a to b. \pre both have places, and it is no base edge
    [[nodiscard]] std::optional<std::vector<WallCrossing>> follow(std::int32_t a, std::int32_t b) const;

    std::size_t ambiguous_vertices = 0; ///< those that a face reaches too which has no vertex of their face

private:
    const BaseFaces* base_;
    const Meshes* meshes_;
    std::vector<Place> places_;
    std::vector<std::int32_t> star_of_; ///< per scan vertex, into stars_, or -1
    std::vector<PillarStar> stars_;
};

/// Finds the association. Kept vertices lie at t = 0 at their base vertex; of the others several places are resolved by
/// continuity: the right one is that to which a scan edge leads from a neighbour whose place is known. Where no vertex
/// of a part of the scan has one place only, every place of one of them is tried, and the first that can be continued
/// over the whole part is taken. Violations: `no_preimage`; `border` for a point on the outermost wall;
/// `several_preimages`, if another place is in a face that shares a vertex with that of the right one; `orientation` if
/// K fails.
class Associator {
public:
    Associator(const BaseFaces& base, const Meshes& meshes)
        : base_(base), meshes_(meshes), scan_(meshes.scan), scan_adjacency_(meshes.scan_adjacency), index_(base) {}

    [[nodiscard]] Association associate(Stages& stages, double share, Findings& findings) const;

private:
    /// What is found of one vertex before its neighbours are asked.
    struct Answer {
        Place place;
        bool several = false;
        std::optional<Violation> violation;
    };
    [[nodiscard]] Answer locate_vertex(std::int32_t vertex) const;
    [[nodiscard]] Answer locate_kept(std::int32_t base_vertex) const;
    [[nodiscard]] bool is_used(std::int32_t vertex) const;
    void resolve(std::vector<std::int32_t> open, Association& association) const;
    [[nodiscard]] bool has_another_nearby(std::int32_t vertex, const Place& place) const;
    void continue_from_neighbours(std::vector<std::int32_t>& open, Association& association) const;
    [[nodiscard]] std::vector<std::int32_t> placed_neighbours(std::int32_t vertex,
                                                              const Association& association) const;
    [[nodiscard]] Place continued(std::int32_t vertex, const Association& association) const;
    void break_deadlock(const std::vector<std::int32_t>& open, Association& association) const;
    [[nodiscard]] std::vector<std::int32_t> part_of(std::int32_t first, std::vector<std::uint8_t>& waiting) const;
    void place_part(const std::vector<std::int32_t>& part, Association& association) const;
    [[nodiscard]] bool is_closed(const std::vector<std::int32_t>& part, const Association& association) const;
    [[nodiscard]] std::vector<Place> by_distance(std::int32_t vertex) const;

    const BaseFaces& base_;
    const Meshes& meshes_;
    const Scan& scan_;
    const Adjacency& scan_adjacency_;
    PrismoidIndex index_;
};

} // namespace foldless::verification
