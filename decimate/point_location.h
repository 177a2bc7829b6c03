/// \file
/// Where a scan vertex lies on the new faces of a patch.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/prismoid.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/prismoid_point.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace foldless {

/// A certified place of a scan vertex on a cell.
struct Lift {
    int cell;
    Enclosure at;
    Walls walls; ///< those on which it lies, exactly

    /// For the exact predicates; refers to the triangle of the cell and to the position of the vertex.
    [[nodiscard]] PrismoidPoint point(const BaseTriangle& triangle, const Vec3& q) const;
};

/// The place near a solution that is known up to rounding: nothing if that is outside the triangle. Exact.
[[nodiscard]] std::optional<Lift> lift_of(int cell, const BaseTriangle& triangle, const Vec3& q, const Enclosure& at);

/// The stored place of a scan vertex, which is on this cell: nothing if rounding hides that it is there.
[[nodiscard]] std::optional<Lift> lift_of_place(const PatchedSurface& surface, int cell, const Vec3& q,
                                                const Place& place);

/// Whether two places are the same point on the common wall of their cells.
[[nodiscard]] bool same_point(PatchedSurface& surface, const Lift& a, const Lift& b);

/// The place of a point, as one in the lower of the two cells of its wall if it lies on one: that is its owner. An
/// impassable cell owns none.
[[nodiscard]] Lift in_lower_cell(PatchedSurface& surface, const Lift& lift);

/// Whether a solution lies so far outside its triangle that no enclosure is needed to say so.
[[nodiscard]] bool is_clearly_outside(const Preimage& preimage);

/// Which inverse displacements compete with each other.
enum class Uniqueness {
    in_range,  ///< those within the ranges of the faces
    fold_free, ///< all with J > 0, at any displacement (Collins & Hilton 2002, read literally)
};

/// Finds the inverse displacements of scan vertices on the new cells of a patched surface.
class PointLocation {
public:
    /// Prepares the new cells. `jacobian` if J <= 0 at a corner of one, else `accepted`.
    [[nodiscard]] Verdict reset(PatchedSurface& surface, Uniqueness uniqueness);

    /// Most points of one call to solve().
    static constexpr std::size_t most_points = 8 * PointBatch::capacity;

    /// Finds the solutions for some points, for locate() to judge: face by face, many points at a time.
    void solve(std::span<const Vec3> points);

    /// The place of point k of the last call to solve(). Fails with `no_preimage`, `several_preimages`, `tie` if it
    /// lies on a pillar or on a wall without another side, or `undecided`.
    [[nodiscard]] Verdict locate(int k, Lift& lift);

    /// Inverse displacements that the last call to locate() found beside the one it chose; they must turn out to lie
    /// outside the ranges of their cells.
    [[nodiscard]] const std::vector<Lift>& alternatives() const { return alternatives_; }

private:
    struct Prepared {
        int cell;
        Prismoid prismoid; ///< over the range in which J > 0 at the corners
    };

    /// A solution of a point that may be inside its cell.
    struct Candidate {
        int cell;
        int next;      ///< the next of the same point, in order of cells, or -1
        bool is_known; ///< false if the solutions in the cell are not a finite list
        Preimage preimage;
    };

    void solve_in(const Prepared& prepared);
    void solve_fold_free_in(const Prepared& prepared);
    void solve_survivors_in(const Prepared& prepared);
    void add(int k, int cell, const Preimages& preimages);
    void add(int k, int cell, const Preimage& preimage);
    void append(int k, const Candidate& candidate);
    [[nodiscard]] Vec3 point(int k) const;
    void judge(const Candidate& candidate, const Vec3& q);
    [[nodiscard]] Verdict on_open_wall(const Lift& lift) const;

    PatchedSurface* surface_ = nullptr;
    Uniqueness uniqueness_ = Uniqueness::in_range;
    InstructionSet instructions_ = best_instruction_set();
    std::vector<Prepared> prepared_;
    std::vector<PointBatch> batches_; ///< the points of solve(), in order
    std::vector<Candidate> candidates_;
    std::vector<int> first_, last_;                    ///< of each point in candidates_, or -1
    PointBatch survivors_;                             ///< points that the cell at hand may hold
    std::array<int, PointBatch::capacity> survivor_{}; ///< which points these are
    std::vector<Lift> found_;
    std::vector<Lift> alternatives_;
    Verdict failure_ = Verdict::accepted; ///< while solutions are collected
};

} // namespace foldless
