#include <foldless/decimate/point_location.h>

#include <foldless/predicates/jacobian.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace foldless {
namespace {

/// Barycentric distance beyond which a solution counts as outside without an enclosure: far above the rounding of the
/// closed form on any triangle that enclose() can certify.
constexpr double clearly_outside = 1e-5;

} // namespace

PrismoidPoint Lift::point(const BaseTriangle& triangle, const Vec3& q) const {
    return {Displacement::of_point(triangle, q, {at.t - at.t_error, at.t + at.t_error}), walls};
}

std::optional<Lift> lift_of(int cell, const BaseTriangle& triangle, const Vec3& q, const Enclosure& at) {
    Lift lift{cell, at, 0};
    for (int k = 0; k < 3; ++k) {
        Sign sign = sign_within(at.alpha[k], at.alpha_error);
        if (sign == Sign::undecided) {
            sign = sign_of_coordinate(triangle, k, q, lift.point(triangle, q).t);
        }
        if (sign == Sign::negative) {
            return std::nullopt;
        }
        lift.walls |= sign == Sign::zero ? wall_bit(k) : 0U;
    }
    return lift;
}

std::optional<Lift> lift_of_place(const PatchedSurface& surface, int cell, const Vec3& q, const Place& place) {
    const BaseTriangle& triangle = surface.cell(cell).triangle;
    const std::optional<Enclosure> at = enclose(triangle, q, place.alpha, place.t);
    return at ? lift_of(cell, triangle, q, *at) : std::nullopt;
}

bool same_point(PatchedSurface& surface, const Lift& a, const Lift& b) {
    for (int k = 0; k < 3; ++k) {
        if ((a.walls & wall_bit(k)) == 0 || surface.neighbour(a.cell, k) != b.cell) {
            continue;
        }
        for (int m = 0; m < 3; ++m) {
            if ((b.walls & wall_bit(m)) != 0 && surface.neighbour(b.cell, m) == a.cell) {
                return true;
            }
        }
    }
    return false;
}

Lift in_lower_cell(PatchedSurface& surface, const Lift& lift) {
    if (std::popcount(lift.walls) != 1) {
        return lift;
    }
    const int wall = std::countr_zero(lift.walls);
    const int other = surface.neighbour(lift.cell, wall);
    if (other == border || other > lift.cell || surface.cell(other).impassable) {
        return lift;
    }
    // The other cell runs along the edge the other way.
    const int first = (wall + 1) % 3;
    const int second = (wall + 2) % 3;
    const int there = surface.corner_of(other, surface.cell(lift.cell).corners[first]);
    Lift result{other, lift.at, wall_bit((there + 1) % 3)};
    result.at.alpha[there] = lift.at.alpha[first];
    result.at.alpha[(there + 1) % 3] = lift.at.alpha[wall];
    result.at.alpha[(there + 2) % 3] = lift.at.alpha[second];
    return result;
}

bool is_clearly_outside(const Preimage& preimage) {
    return preimage.alpha.minCoeff() < -clearly_outside;
}

Verdict PointLocation::reset(PatchedSurface& surface, Uniqueness uniqueness) {
    surface_ = &surface;
    uniqueness_ = uniqueness;
    prepared_.clear();
    for (int c = 0; c < surface.new_cells(); ++c) {
        Cell& cell = surface.cell(c);
        if (cell.impassable) {
            continue;
        }
        const Range fold_free = fold_free_range(cell.triangle);
        if (!(fold_free.lo < fold_free.hi)) {
            return Verdict::jacobian;
        }
        cell.range = fold_free; // until the displacements that are met are known
    }
    for (int c = 0; c < surface.new_cells(); ++c) {
        const Cell& cell = surface.cell(c);
        if (!cell.impassable) {
            prepared_.push_back({c, Prismoid(cell.triangle, cell.range)});
        }
    }
    return Verdict::accepted;
}

void PointLocation::solve(std::span<const Vec3> points) {
    batches_.clear();
    for (const Vec3& q : points) {
        if (batches_.empty() || batches_.back().size == PointBatch::capacity) {
            batches_.emplace_back();
        }
        batches_.back().push_back(q, {0, 0});
    }
    candidates_.clear();
    first_.assign(points.size(), -1);
    last_.assign(points.size(), -1);
    for (const Prepared& prepared : prepared_) {
        if (uniqueness_ == Uniqueness::fold_free) {
            solve_fold_free_in(prepared);
        } else {
            solve_in(prepared);
        }
    }
}

void PointLocation::solve_fold_free_in(const Prepared& prepared) {
    for (int k = 0; k < static_cast<int>(first_.size()); ++k) {
        add(k, prepared.cell, prepared.prismoid.preimages(point(k)));
    }
}

void PointLocation::solve_in(const Prepared& prepared) {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        PointBatch& batch = batches_[b];
        for (unsigned left = prepared.prismoid.displacements(batch, instructions_); left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            survivor_[survivors_.size] = static_cast<int>(b) * PointBatch::capacity + k;
            survivors_.push_back(batch.point(k), batch.range(k));
            if (survivors_.size == PointBatch::capacity) {
                solve_survivors_in(prepared);
            }
        }
    }
    solve_survivors_in(prepared);
}

void PointLocation::solve_survivors_in(const Prepared& prepared) {
    const BatchInversion inversion(prepared.prismoid.inverse(), survivors_, instructions_);
    for (unsigned left = inversion.candidates(); left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        if ((inversion.single() >> k & 1U) != 0) {
            add(survivor_[k], prepared.cell, inversion.preimage(k));
        } else {
            add(survivor_[k], prepared.cell, inversion.preimages(k));
        }
    }
    survivors_.size = 0;
}

void PointLocation::add(int k, int cell, const Preimages& preimages) {
    if (preimages.kind == Preimages::Kind::infinite) {
        return append(k, {cell, -1, false, {}});
    }
    for (const Preimage& preimage : preimages) {
        add(k, cell, preimage);
    }
}

void PointLocation::add(int k, int cell, const Preimage& preimage) {
    if (preimage.slope > 0 && !is_clearly_outside(preimage)) {
        append(k, {cell, -1, true, preimage});
    }
}

void PointLocation::append(int k, const Candidate& candidate) {
    const int index = static_cast<int>(candidates_.size());
    (first_[k] < 0 ? first_[k] : candidates_[last_[k]].next) = index;
    last_[k] = index;
    candidates_.push_back(candidate);
}

Vec3 PointLocation::point(int k) const {
    return batches_[k / PointBatch::capacity].point(k % PointBatch::capacity);
}

void PointLocation::judge(const Candidate& candidate, const Vec3& q) {
    if (!candidate.is_known) {
        failure_ = Verdict::undecided;
        return;
    }
    const BaseTriangle& triangle = surface_->cell(candidate.cell).triangle;
    const std::optional<Enclosure> at = enclose(triangle, q, candidate.preimage.alpha, candidate.preimage.t);
    if (!at) {
        failure_ = Verdict::undecided;
        return;
    }
    if (const std::optional<Lift> lift = lift_of(candidate.cell, triangle, q, *at)) {
        found_.push_back(*lift);
        if (std::popcount(lift->walls) > 1) { // only a kept vertex may be on a pillar
            failure_ = Verdict::tie;
        }
    }
}

Verdict PointLocation::on_open_wall(const Lift& lift) const {
    // Where J > 0 on both sides the prismoids lie on opposite sides of their common wall (lemma L8), so a point on the
    // wall has one place. Beyond a wall of the border or of an impassable cell there is no other side.
    for (int k = 0; k < 3; ++k) {
        if ((lift.walls & wall_bit(k)) != 0) {
            const int other = surface_->neighbour(lift.cell, k);
            return other == border || surface_->cell(other).impassable ? Verdict::tie : Verdict::accepted;
        }
    }
    return Verdict::accepted;
}

Verdict PointLocation::locate(int k, Lift& lift) {
    found_.clear();
    alternatives_.clear();
    failure_ = Verdict::accepted;
    for (int c = first_[k]; c >= 0; c = candidates_[c].next) {
        judge(candidates_[c], point(k));
    }
    if (failure_ != Verdict::accepted) {
        return failure_;
    }
    if (found_.empty()) {
        return Verdict::no_preimage;
    }
    // The first of the nearest: cells are in order, so a point on a wall belongs to the lower of its two cells.
    const auto nearer = [](const Lift& a, const Lift& b) { return std::abs(a.at.t) < std::abs(b.at.t); };
    lift = *std::min_element(found_.begin(), found_.end(), nearer);
    for (const Lift& other : found_) {
        if (other.cell < lift.cell && same_point(*surface_, other, lift)) {
            lift = other;
        }
    }
    for (const Lift& other : found_) {
        const bool chosen = other.cell == lift.cell && other.at.t == lift.at.t;
        if (!chosen && !same_point(*surface_, other, lift)) {
            alternatives_.push_back(other);
        }
    }
    if (uniqueness_ == Uniqueness::fold_free && !alternatives_.empty()) {
        return Verdict::several_preimages;
    }
    return on_open_wall(lift);
}

} // namespace foldless
