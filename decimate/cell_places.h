/// \file
/// Whether a point has a place in one given cell, within its range.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/point_location.h>
#include <foldless/decimate/prismoid.h>
#include <foldless/decimate/verdict.h>

#include <optional>

namespace foldless {

using Box = Eigen::AlignedBox3d;

/// The prismoid of a cell over its range, prepared to be asked about many points that lie elsewhere.
class CellPlaces {
public:
    CellPlaces(PatchedSurface& surface, int cell);

    [[nodiscard]] int cell() const { return cell_; }

    /// False if q is outside the box around the prismoid.
    [[nodiscard]] bool may_hold(const Vec3& q) const { return box_.contains(q); }
    [[nodiscard]] const Box& box() const { return box_; }

    /// `accepted` if q, whose place is `known`, has no other place in this cell: none at all, or the same point on the
    /// common wall. `several_preimages` if it has one, `undecided` if rounding hides it.
    [[nodiscard]] Verdict lacks(const Vec3& q, const Lift& known) const;

private:
    PatchedSurface* surface_;
    int cell_;
    mutable std::optional<Prismoid> prismoid_; ///< prepared when first asked: few cells ever are
    Box box_;
};

} // namespace foldless
