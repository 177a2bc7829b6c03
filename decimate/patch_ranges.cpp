#include <foldless/decimate/patch_ranges.h>

#include <foldless/io/float32.h>
#include <foldless/predicates/pillar.h>

#include <algorithm>
#include <limits>

namespace foldless {
void PatchRanges::reset(PatchedSurface& surface) {
    surface_ = &surface;
    const double infinity = std::numeric_limits<double>::infinity();
    hulls_.assign(surface.new_cells(), {infinity, -infinity});
}

Verdict PatchRanges::reach(int cell, const Displacement& t) {
    if (cell < surface_->new_cells()) {
        extend(cell, t.bounds());
        return Verdict::accepted;
    }
    return within(t, surface_->cell(cell).range) == Sign::negative ? Verdict::out_of_range : Verdict::accepted;
}

Verdict PatchRanges::reach_pillar(std::int32_t vertex, const ScanTriangle& q) {
    const DisplacedVertex pillar{surface_->vertex(vertex).position, surface_->vertex(vertex).direction};
    for (const int cell : surface_->fan(vertex).cells) {
        if (cell < surface_->new_cells()) {
            extend(cell, displacement_at_plane(pillar, q));
        } else if (!meets_plane_within(pillar, q, surface_->cell(cell).range)) {
            return Verdict::out_of_range;
        }
    }
    return Verdict::accepted;
}

Range PatchRanges::rounded(int cell) const {
    const Range& hull = hulls_[cell];
    return hull.lo <= hull.hi ? Range{float32_below(hull.lo), float32_above(hull.hi)} : Range{0.0, 0.0};
}

void PatchRanges::extend(int cell, Range t) {
    hulls_[cell].lo = std::min(hulls_[cell].lo, t.lo);
    hulls_[cell].hi = std::max(hulls_[cell].hi, t.hi);
}

} // namespace foldless
