#include <foldless/decimate/point_location.h>

#include <foldless/predicates/jacobian.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// Relative slack of the planes that cull: far above their rounding (1e-15), far below the size of a face, so that
/// culling is safe and still sharp.
constexpr double cull_slack = 1e-9;

/// Barycentric distance beyond which a solution counts as outside without an enclosure: far above the rounding of the
/// closed form on any triangle that enclose() can certify.
constexpr double clearly_outside = 1e-5;

} // namespace

int wall_of(const Enclosure& at) {
    for (int k = 0; k < 3; ++k) {
        if (at.alpha[k] <= at.alpha_error) {
            return k;
        }
    }
    return -1;
}

bool same_point(PatchedSurface& surface, const Lift& a, const Lift& b) {
    return a.wall >= 0 && b.wall >= 0 && surface.neighbour(a.cell, a.wall) == b.cell &&
           surface.neighbour(b.cell, b.wall) == a.cell;
}

bool is_clearly_outside(const Preimage& preimage) {
    return preimage.alpha.minCoeff() < -clearly_outside;
}

PointLocation::Prepared::Prepared(const BaseTriangle& triangle, int index, Range range)
    : cell(index), fold_free(range), inverse(triangle), origin(triangle.v[0]) {
    const Vec3 e1 = triangle.v[1] - triangle.v[0];
    const Vec3 e2 = triangle.v[2] - triangle.v[0];
    normal = e1.cross(e2);
    const std::array<double, 3> speed{triangle.d[0].dot(normal), triangle.d[1].dot(normal), triangle.d[2].dot(normal)};
    slowest = *std::min_element(speed.begin(), speed.end());
    fastest = *std::max_element(speed.begin(), speed.end());
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3;
        const int j = (k + 2) % 3;
        outward[k] = (triangle.v[j] - triangle.v[i]).cross(triangle.d[i] + triangle.d[j]);
        level[k] = Vec3(0, outward[k].dot(e1), outward[k].dot(e2));
        drift[k] = Vec3(outward[k].dot(triangle.d[0]), outward[k].dot(triangle.d[1]), outward[k].dot(triangle.d[2]));
        slack[k] = cull_slack * outward[k].cwiseAbs().sum() * (e1.cwiseAbs().sum() + e2.cwiseAbs().sum());
    }
}

bool PointLocation::Prepared::excludes(const Vec3& q) const {
    // A solution inside the triangle moves by t d(alpha), whose height t d(alpha).normal is that of q, and
    // d(alpha).normal lies between `slowest` and `fastest`, both positive. That brackets t; at such t the slice lies
    // within the hull of the corners at the two ends of the bracket, hence behind the plane k through its furthest one.
    const Vec3 p = q - origin;
    const double height = p.dot(normal);
    double lo = height / (height >= 0 ? fastest : slowest);
    double hi = height / (height >= 0 ? slowest : fastest);
    const double widen = cull_slack * (std::abs(lo) + std::abs(hi));
    lo = std::max(lo - widen, fold_free.lo);
    hi = std::min(hi + widen, fold_free.hi);
    if (lo > hi) {
        return true;
    }
    for (int k = 0; k < 3; ++k) {
        double furthest = -std::numeric_limits<double>::infinity();
        for (int c = 0; c < 3; ++c) {
            furthest = std::max(furthest, level[k][c] + std::max(lo * drift[k][c], hi * drift[k][c]));
        }
        if (p.dot(outward[k]) > furthest + slack[k]) {
            return true;
        }
    }
    return false;
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
        prepared_.emplace_back(cell.triangle, c, fold_free);
    }
    return Verdict::accepted;
}

void PointLocation::collect(const Prepared& prepared, const Vec3& q) {
    const BaseTriangle& triangle = surface_->cell(prepared.cell).triangle;
    const Preimages preimages = prepared.inverse.preimages(q);
    if (preimages.kind == Preimages::Kind::infinite) {
        undecided_ = true;
        return;
    }
    for (const Preimage& preimage : preimages) {
        const bool reachable = uniqueness_ == Uniqueness::fold_free ||
                               (preimage.t > prepared.fold_free.lo && preimage.t < prepared.fold_free.hi);
        if (!reachable || !(preimage.slope > 0) || is_clearly_outside(preimage)) {
            continue;
        }
        const std::optional<Enclosure> at = enclose(triangle, q, preimage.alpha, preimage.t);
        if (!at) {
            undecided_ = true;
            continue;
        }
        int walls = 0;
        bool outside = false;
        for (int k = 0; k < 3; ++k) {
            outside = outside || at->alpha[k] < -at->alpha_error;
            walls += at->alpha[k] <= at->alpha_error ? 1 : 0;
        }
        if (!outside) {
            found_.push_back({prepared.cell, *at, wall_of(*at)});
            undecided_ = undecided_ || walls > 1; // on a pillar: only a kept vertex may be there
        }
    }
}

Verdict PointLocation::on_open_wall(const Lift& lift) const {
    // Where J > 0 on both sides the prismoids lie on opposite sides of their common wall, so a point that rounding puts
    // on the wall has its place on this side, on the wall, or on the other side: in each case exactly one. Beyond a
    // wall of the border or of an impassable cell there is no other side.
    if (lift.wall < 0) {
        return Verdict::accepted;
    }
    const int other = surface_->neighbour(lift.cell, lift.wall);
    return other == border || surface_->cell(other).impassable ? Verdict::undecided : Verdict::accepted;
}

Verdict PointLocation::locate(const Vec3& q, Lift& lift) {
    found_.clear();
    alternatives_.clear();
    undecided_ = false;
    for (const Prepared& prepared : prepared_) {
        if (uniqueness_ == Uniqueness::fold_free || !prepared.excludes(q)) {
            collect(prepared, q);
        }
    }
    if (undecided_) {
        return Verdict::undecided;
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
