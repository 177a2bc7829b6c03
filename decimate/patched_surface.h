/// \file
/// The base mesh as it would be with a patch in place, without touching it.
#pragma once

#include <foldless/decimate/index_map.h>
#include <foldless/decimate/patch.h>
#include <foldless/predicates/vector.h>
#include <foldless/predicates/wall.h>

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace foldless {

/// A face of the patched surface, prepared for questions. New faces come first and are the patch's, in order; faces
/// outside the patch are added when a question reaches them.
struct Cell {
    std::int32_t face;             ///< base face outside the patch, or -1 for a new face
    Triangle corners;              ///< base vertices
    std::array<bool, 3> kept;      ///< which corners are kept vertices
    std::array<int, 3> neighbours; ///< cells opposite each corner, or one of the values below
    BaseTriangle triangle;         ///< positions and directions
    Range range;                   ///< outside: the stored one; new: where J > 0 can hold, then the hull
    bool impassable;               ///< a scan face that represents itself: nothing may enter it

    /// The wall opposite corner k, prepared when it is first asked for.
    [[nodiscard]] const Wall& wall(int k) const {
        if (!walls[k]) {
            walls[k].emplace(triangle, k);
        }
        return *walls[k];
    }
    mutable std::array<std::optional<Wall>, 3> walls;
};

/// Values of Cell::neighbours that are no cell.
inline constexpr int border = -1;
inline constexpr int not_yet_known = -2;

/// Where the edges of a fan of cells around a vertex lie: cell c between edges c and c + 1, counter-clockwise.
struct Fan {
    std::int32_t vertex;
    std::vector<int> cells;
    std::vector<std::int32_t> spokes; ///< the base vertex at the far end of each edge; one more than cells if open
    bool closed = true;
};

/// The displacement direction of a face with constant directions: its unit normal, rounded to float32, whatever the
/// unit of length. Finite corners are assumed.
[[nodiscard]] Vec3 face_direction(const std::array<Vec3, 3>& corners);

class PatchedSurface {
public:
    explicit PatchedSurface(const BaseSurface& base) : base_(&base) {}

    /// Prepares the questions about one patch; the patch must outlive them. With `constant_directions` every face has
    /// its own normal as the direction of its corners.
    void reset(const Patch& patch, bool constant_directions);

    [[nodiscard]] int new_cells() const { return static_cast<int>(patch_->added.size()); }
    /// Stays where it is until the next reset().
    [[nodiscard]] Cell& cell(int c) { return *cells_[c]; }
    [[nodiscard]] const Cell& cell(int c) const { return *cells_[c]; }
    [[nodiscard]] BaseVertex vertex(std::int32_t v) const;
    [[nodiscard]] const BaseSurface& base() const { return *base_; }

    /// Whether the patch takes this base face away.
    [[nodiscard]] bool removes(std::int32_t face) const { return removed_.contains(face); }
    /// The cell of a base face outside the patch.
    [[nodiscard]] int cell_of(std::int32_t face);
    /// The cell across the wall opposite corner k, or `border`.
    [[nodiscard]] int neighbour(int c, int k);
    /// The corner of the cell that the base vertex is, or -1.
    [[nodiscard]] int corner_of(int c, std::int32_t v) const;
    /// Whether two cells have a corner in common.
    [[nodiscard]] bool share_corner(int a, int b) const;
    /// The passable cells outside the patch that share a corner with a new cell.
    void cells_beside(std::vector<int>& out);
    /// Appends the base faces outside the patch that were looked at, some more than once.
    void append_read(std::vector<std::int32_t>& out) const;
    /// The fan of cells around a vertex of the patched surface; stays where it is until the next reset.
    [[nodiscard]] const Fan& fan(std::int32_t v);

private:
    void prepare(std::int32_t face, const Triangle& corners, bool impassable);
    [[nodiscard]] bool represents_itself(const PatchFace& face) const;
    [[nodiscard]] int new_cell_along(std::int32_t from, std::int32_t to) const;
    [[nodiscard]] int find_neighbour(int c, int k);
    void find_rim();
    [[nodiscard]] int any_cell_at(std::int32_t v);
    void walk_around(Fan& fan);

    const BaseSurface* base_;
    const Patch* patch_ = nullptr;
    bool constant_directions_ = false;
    std::vector<std::unique_ptr<Cell>> cells_; ///< the first cells_used_ are of this patch
    int cells_used_ = 0;
    IndexMap removed_;  ///< the base faces that go
    IndexMap cell_for_; ///< of base faces outside the patch
    /// An edge of the rim, in the orientation of the patch, and the face that stays on its other side.
    struct RimEdge {
        std::int32_t from, to;
        std::int32_t outer;
    };
    std::vector<RimEdge> rim_;
    std::deque<Fan> fans_; ///< those asked for; the first fans_used_ are of this patch
    std::size_t fans_used_ = 0;
    std::vector<std::int32_t> around_;     ///< scratch
    std::vector<std::int32_t> impassable_; ///< base faces beside the patch that are no cells
};

} // namespace foldless
