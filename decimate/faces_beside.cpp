#include <foldless/decimate/faces_beside.h>

#include <optional>

namespace foldless {

Verdict FacesBeside::test(PatchedSurface& surface, const std::vector<NewLift>& lifts) {
    surface_ = &surface;
    Verdict verdict = test_frozen_walls();
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    surface.cells_beside(beside_);
    for (const int outer : beside_) {
        verdict = test_new_places_in(outer, lifts);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    prepare_new_cells();
    for (const int outer : beside_) {
        verdict = test_vertices_of(outer);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict FacesBeside::test_frozen_walls() const {
    for (int c = 0; c < surface_->new_cells(); ++c) {
        for (int k = 0; k < 3 && surface_->cell(c).impassable; ++k) {
            const int outer = surface_->neighbour(c, k);
            if (outer < surface_->new_cells() || surface_->cell(outer).impassable) {
                continue;
            }
            const int corner = surface_->corner_of(outer, surface_->cell(c).corners[(k + 1) % 3]);
            const Verdict verdict = test_wall(outer, (corner + 1) % 3);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

Verdict FacesBeside::test_wall(int outer, int k) const {
    constexpr double near = 1e-6; // far above the rounding of places
    const BaseSurface& base = surface_->base();
    for (std::int32_t v = base.face(surface_->cell(outer).face).first_vertex; v >= 0; v = base.next_on_face(v)) {
        const Place place = base.place(v);
        if (place.alpha[k] > near) {
            continue;
        }
        const std::optional<Lift> lift = lift_of_place(*surface_, outer, scan_->positions[v], place);
        if (!lift || (lift->walls & wall_bit(k)) != 0) {
            return lift ? Verdict::tie : Verdict::undecided;
        }
    }
    return Verdict::accepted;
}

/// Few of the new places are near: boxes sort out nearly all.
Verdict FacesBeside::test_new_places_in(int outer, const std::vector<NewLift>& lifts) const {
    const CellPlaces there(*surface_, outer);
    for (const NewLift& placed : lifts) {
        const Vec3& q = scan_->positions[placed.scan_vertex];
        if (!there.may_hold(q) || !surface_->share_corner(outer, placed.lift.cell)) {
            continue;
        }
        const Verdict verdict = there.lacks(q, placed.lift);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

void FacesBeside::prepare_new_cells() {
    here_.clear();
    around_here_.setEmpty();
    for (int c = 0; c < surface_->new_cells(); ++c) {
        if (!surface_->cell(c).impassable) {
            here_.emplace_back(*surface_, c);
            around_here_.extend(here_.back().box());
        }
    }
}

Verdict FacesBeside::test_vertices_of(int outer) const {
    const BaseSurface& base = surface_->base();
    for (std::int32_t v = base.face(surface_->cell(outer).face).first_vertex; v >= 0; v = base.next_on_face(v)) {
        const Vec3& q = scan_->positions[v];
        if (!around_here_.contains(q)) {
            continue;
        }
        for (const CellPlaces& here : here_) {
            if (!here.may_hold(q) || !surface_->share_corner(outer, here.cell())) {
                continue;
            }
            const std::optional<Lift> known = lift_of_place(*surface_, outer, q, base.place(v));
            const Verdict verdict = known ? here.lacks(q, *known) : Verdict::undecided;
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

} // namespace foldless
