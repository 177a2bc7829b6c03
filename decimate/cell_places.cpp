#include <foldless/decimate/cell_places.h>

namespace foldless {

CellPlaces::CellPlaces(PatchedSurface& surface, int cell) : surface_(&surface), cell_(cell) {
    // The prismoid lies in the hull of the corners of its two end slices.
    const BaseTriangle& triangle = surface.cell(cell).triangle;
    const Range range = surface.cell(cell).range;
    for (int k = 0; k < 3; ++k) {
        for (const double t : {range.lo, range.hi}) {
            box_.extend(triangle.corner(k, t));
        }
    }
    // Far more than rounding moves a corner, far less than the size of a face.
    constexpr double slack = 1e-9;
    const Vec3 widen = Vec3::Constant(slack * box_.sizes().maxCoeff());
    box_ = Box(box_.min() - widen, box_.max() + widen);
}

Verdict CellPlaces::lacks(const Vec3& q, const Lift& known) const {
    if (!prismoid_) {
        prismoid_.emplace(surface_->cell(cell_).triangle, surface_->cell(cell_).range);
    }
    const std::optional<Range> part = prismoid_->displacements(q);
    if (!part) {
        return Verdict::accepted;
    }
    const Range range = prismoid_->range();
    const Preimages preimages = prismoid_->preimages(q, *part);
    if (preimages.kind == Preimages::Kind::infinite) {
        return Verdict::undecided;
    }
    for (const Preimage& preimage : preimages) {
        if (is_clearly_outside(preimage)) {
            continue;
        }
        const std::optional<Enclosure> at = enclose(surface_->cell(cell_).triangle, q, preimage.alpha, preimage.t);
        if (!at) {
            return Verdict::undecided;
        }
        const bool in_range = at->t + at->t_error >= range.lo && at->t - at->t_error <= range.hi;
        const std::optional<Lift> lift =
            in_range ? lift_of(cell_, surface_->cell(cell_).triangle, q, *at) : std::nullopt;
        if (lift && !same_point(*surface_, known, *lift)) {
            return Verdict::several_preimages;
        }
    }
    return Verdict::accepted;
}

} // namespace foldless
