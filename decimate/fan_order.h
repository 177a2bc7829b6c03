/// \file
/// Condition K: how the scan edges that leave a kept vertex lie in the fan of base faces around it.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/scan_topology.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/view_along.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// The fan of a kept vertex with the position of every scan edge that leaves it, seen along its direction.
///
/// Refers to the fan that the patched surface holds, until that is reset.
///
/// Positions count half steps counter-clockwise: the base edge to spokes[c] is at 2c, the inside of cell c at 2c + 1.
class FanOrder {
public:
    /// Sorts the scan edges of the kept base vertex `v` into its fan and checks that they go round once: `accepted`,
    /// `orientation` if they do not, `no_preimage` if an edge starts outside the fan or in an impassable cell. One that
    /// is seen exactly along a base edge that it is not starts on the side to which it leaves the wall; if it stays in
    /// the wall, in the lower of the two cells there, which owns it; `tie` if a cell is missing or impassable.
    /// `jacobian` if the base fan itself turns too far.
    [[nodiscard]] Verdict reset(std::int32_t v, PatchedSurface& surface, const Scan& scan,
                                const ScanTopology& topology);

    [[nodiscard]] std::int32_t vertex() const { return vertex_; }
    [[nodiscard]] const Fan& fan() const { return *fan_; }

    /// Position of the scan edge to the scan vertex `neighbour`.
    [[nodiscard]] int position(std::int32_t neighbour) const;
    /// Whether the scan edge to `neighbour` is a base edge.
    [[nodiscard]] bool is_base_edge(std::int32_t neighbour) const { return position(neighbour) % 2 == 0; }
    /// The cell in which the scan edge to `neighbour` starts; it must not be a base edge.
    [[nodiscard]] int start_cell(std::int32_t neighbour) const { return fan_->cells[position(neighbour) / 2]; }
    /// Half steps counter-clockwise from one position to another.
    [[nodiscard]] int steps(int from, int to) const;

private:
    struct Edge {
        std::int32_t neighbour;
        int position;
    };
    /// An edge that leaves the vertex, seen along its direction.
    struct Sighting {
        Vec3 end;
        ViewAlong::Seen seen;
    };
    [[nodiscard]] Sign follows(const Sighting& a, const Sighting& b) const;
    void look_along_spokes(const PatchedSurface& surface);
    [[nodiscard]] Verdict sort_edges(std::int32_t scan_vertex, const PatchedSurface& surface, const Scan& scan,
                                     const ScanTopology& topology);
    [[nodiscard]] Verdict add_edge(std::int32_t neighbour, const Sighting& edge, const PatchedSurface& surface);
    [[nodiscard]] Verdict find_cell(const Sighting& edge, const PatchedSurface& surface, int& cell) const;
    [[nodiscard]] Verdict find_cell_along(std::size_t c, const Sighting& edge, const PatchedSurface& surface,
                                          int& cell) const;
    [[nodiscard]] Verdict base_turns_once(const PatchedSurface& surface) const;
    [[nodiscard]] Verdict no_sector_holds(std::size_t spoke, std::size_t first, std::size_t last) const;
    [[nodiscard]] Verdict goes_round_once(std::int32_t scan_vertex, const Scan& scan,
                                          const ScanTopology& topology) const;

    std::int32_t vertex_ = -1;
    const Fan* fan_ = nullptr;
    /// A base edge that leaves the vertex.
    struct Spoke {
        std::int32_t scan_vertex; ///< what its far end is kept as, or -1
        Sighting sighting;
    };
    Vec3 centre_ = Vec3::Zero(); ///< the vertex
    Vec3 direction_ = Vec3::Zero();
    std::vector<Spoke> spokes_;
    std::vector<Edge> edges_;
};

} // namespace foldless
