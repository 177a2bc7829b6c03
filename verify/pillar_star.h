/// \file
/// Condition K: how the scan edges that leave a scan vertex on a pillar lie among the base faces around it.
#pragma once

#include <foldless/verify/base_faces.h>
#include <foldless/verify/edge_trace.h>
#include <foldless/verify/meshes.h>

#include <foldless/predicates/displacement.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace foldless::verification {

/// A scan vertex on the pillar of a base vertex: a kept one at t = 0, or one that lies there by chance.
struct OnPillar {
    std::int32_t scan_vertex;
    std::int32_t base_vertex;
    Displacement t;
};

/// Where each scan edge that leaves the vertex starts: along a base edge that it is (both ends kept), or in a face. An
/// edge that is seen exactly along a base edge that it is not starts on the side to which it leaves the wall; if it
/// stays in the wall, in the lower of the two faces there, which owns it.
///
/// Positions count half steps counter-clockwise in a fan of moving base faces: the base edge before face c at 2c, the
/// face itself at 2c + 1.
class PillarStar {
public:
    /// Nothing if K fails: the base faces or the scan faces go round more than once, seen along the direction, an edge
    /// starts in no moving face, or the edges do not lie in the order of the scan faces. Exact.
    static std::optional<PillarStar> make(const BaseFaces& base, const Meshes& meshes, const OnPillar& vertex);

    /// Whether the scan edge to the neighbour is a base edge.
    [[nodiscard]] bool is_base_edge(std::int32_t neighbour) const { return edge(neighbour).position % 2 == 0; }
    /// The face in which the scan edge to the neighbour starts. \pre it is no base edge
    [[nodiscard]] std::int32_t start_face(std::int32_t neighbour) const;
    /// Appends the far ends of the base edges strictly between two scan edges of one scan face, counter-clockwise, and
    /// the faces between them.
    void between(std::int32_t first, std::int32_t second, std::vector<std::int32_t>& spokes,
                 std::vector<std::int32_t>& faces) const;

private:
    /// The moving base faces in which one fan of moving scan faces lies.
    struct Sectors {
        Fan fan;
        std::vector<std::int32_t> spokes; ///< far ends of the base edges, one more than faces if open
    };
    struct Edge {
        std::int32_t neighbour;
        int sectors; ///< which
        int position;
    };

    PillarStar(const BaseFaces& base, const Meshes& meshes, const OnPillar& vertex)
        : base_(&base), meshes_(&meshes), vertex_(vertex) {}

    [[nodiscard]] bool place_edges();
    [[nodiscard]] bool place_fan(const Fan& scan_fan);
    [[nodiscard]] bool place_in(int sectors, const Fan& scan_fan);
    [[nodiscard]] std::optional<int> position_in(int sectors, std::int32_t neighbour) const;
    [[nodiscard]] std::optional<int> position_along(int sectors, std::size_t spoke, std::int32_t neighbour) const;
    [[nodiscard]] bool go_round_once(int sectors, const Fan& scan_fan) const;
    [[nodiscard]] bool scan_turns_once(const Fan& scan_fan) const;
    [[nodiscard]] Sign turn_to_scan(std::int32_t spoke, std::int32_t neighbour) const;
    [[nodiscard]] const Edge& edge(std::int32_t neighbour) const;
    [[nodiscard]] int steps(const Sectors& sectors, int from, int to) const;

    const BaseFaces* base_;
    const Meshes* meshes_;
    OnPillar vertex_;
    std::vector<Sectors> sectors_;
    std::vector<Edge> edges_;
};

} // namespace foldless::verification
