/// \file
/// Where a scan vertex lies on the new faces of a patch.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/prismoid.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/prismoid_point.h>

#include <optional>
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

    /// The place of q. Fails with `no_preimage`, `several_preimages`, `tie` if it lies on a pillar or on a wall without
    /// another side, or `undecided`.
    [[nodiscard]] Verdict locate(const Vec3& q, Lift& lift);

    /// Inverse displacements that the last call to locate() found beside the one it chose; they must turn out to lie
    /// outside the ranges of their cells.
    [[nodiscard]] const std::vector<Lift>& alternatives() const { return alternatives_; }

private:
    struct Prepared {
        int cell;
        Prismoid prismoid; ///< over the range in which J > 0 at the corners
    };

    void find_in(const Prepared& prepared, const Vec3& q);
    void collect(const Preimages& preimages, const Prepared& prepared, const Vec3& q);
    [[nodiscard]] Verdict on_open_wall(const Lift& lift) const;

    PatchedSurface* surface_ = nullptr;
    Uniqueness uniqueness_ = Uniqueness::in_range;
    std::vector<Prepared> prepared_;
    std::vector<Lift> found_;
    std::vector<Lift> alternatives_;
    Verdict failure_ = Verdict::accepted; ///< while solutions are collected
};

} // namespace foldless
