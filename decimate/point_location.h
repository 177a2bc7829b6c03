/// \file
/// Where a scan vertex lies on the new faces of a patch.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/prismoid.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/enclosure.h>

#include <vector>

namespace foldless {

/// A certified place of a scan vertex on a cell.
struct Lift {
    int cell;
    Enclosure at;
    int wall; ///< the corner opposite the wall on which it lies as far as rounding can tell, or -1
};

/// The corner opposite the wall on which a point inside or on a triangle lies as far as rounding can tell, or -1.
[[nodiscard]] int wall_of(const Enclosure& at);

/// Whether two places are the same point on the common wall of their cells.
[[nodiscard]] bool same_point(PatchedSurface& surface, const Lift& a, const Lift& b);

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

    /// The place of q. Fails with `no_preimage`, `several_preimages` or `undecided`.
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
    bool undecided_ = false;
};

} // namespace foldless
