#include <foldless/verify/place.h>

#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>

namespace foldless::verification {
namespace {

/// Roots with a coordinate below minus this are outside without a proof: a root at which the map is invertible at all
/// has more correct digits than three.
constexpr double rough_alpha = 1e-3;

/// How far (alpha, t) moves at most when q moves by q_error in each coordinate: the rows of the inverse of DF = (e1,
/// e2, d).
void widen(Enclosure& at, const BaseTriangle& triangle, double q_error) {
    const Vec3 e1 = triangle.corner(1, at.t) - triangle.corner(0, at.t);
    const Vec3 e2 = triangle.corner(2, at.t) - triangle.corner(0, at.t);
    const Vec3 d = at.alpha[0] * triangle.d[0] + at.alpha[1] * triangle.d[1] + at.alpha[2] * triangle.d[2];
    const Vec3 normal = e1.cross(e2);
    const double per_distance = q_error / std::abs(normal.dot(d));
    at.alpha_error += per_distance * (sum_norm(e2.cross(d)) + sum_norm(d.cross(e1)));
    at.t_error += per_distance * sum_norm(normal);
}

/// Judges an enclosure against the face: nothing if it is certainly outside.
std::optional<FacePlace> judged(const MovingFace& face, const Enclosure& at) {
    FacePlace place;
    place.at = at;
    for (int k = 0; k < 3; ++k) {
        const Sign sign = sign_within(at.alpha[k], at.alpha_error);
        if (sign == Sign::negative) {
            return std::nullopt;
        }
        place.walls |= sign == Sign::positive ? 0U : wall_bit(k);
    }
    const Sign in_range = within(face.range, at.t, at.t_error);
    if (in_range == Sign::negative) {
        return std::nullopt;
    }
    place.decided = in_range == Sign::positive ||
                    jacobian_on(face.triangle, {at.t - at.t_error, at.t + at.t_error}) == Sign::positive;
    return place;
}

/// A base vertex's corner numbers differ from face to face; this carries barycentric coordinates over.
Vec3 carried_over(const Vec3& alpha, const Triangle& from, const Triangle& to) {
    Vec3 result = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const int there = corner_of(to, from[k]);
        if (there >= 0) {
            result[there] = alpha[k];
        }
    }
    return result;
}

/// With constant face directions two prismoids share their wall's foot only: the base edge itself, at t = 0.
bool shares_walls(const BaseFaces& base, const Enclosure& at) {
    return !base.constant_directions() || std::abs(at.t) <= at.t_error;
}

} // namespace

int pillar_of(Walls walls) {
    for (int k = 0; k < 3; ++k) {
        if (walls == walls_at_corner(k)) {
            return k;
        }
    }
    return -1;
}

Sign within(const Range& range, double t, double t_error) {
    if (t + t_error < range.lo || t - t_error > range.hi) {
        return Sign::negative;
    }
    return t - t_error >= range.lo && t + t_error <= range.hi ? Sign::positive : Sign::undecided;
}

// Corners i = k + 1 and j = k + 2 of the face lie in its neighbour as j, i: the corner after i is the one opposite.
int wall_across(const BaseFaces& base, std::int32_t face, int k) {
    const MovingFace& from = base.face(face);
    return (corner_of(base.face(from.across[k]).corners, from.corners[(k + 1) % 3]) + 1) % 3;
}

std::optional<FacePlace> place_in(const BaseFaces& base, std::int32_t face, const Vec3& q, double q_error) {
    const MovingFace& moving = base.face(face);
    std::optional<FacePlace> found;
    for (const Preimage& preimage : moving.inverse.preimages(q)) {
        if (!(preimage.alpha.minCoeff() > -rough_alpha)) {
            continue;
        }
        std::optional<Enclosure> at = enclose(moving.triangle, q, preimage.alpha, preimage.t);
        std::optional<FacePlace> place;
        if (at) {
            widen(*at, moving.triangle, q_error);
            place = judged(moving, *at);
        } else if (within(moving.range, preimage.t, 0.0) == Sign::positive) {
            place = FacePlace{.decided = false, .at = {preimage.alpha, preimage.t, 0.0, 0.0}};
        }
        if (place && (!found || (place->decided && !found->decided))) {
            place->face = face;
            found = place;
        }
    }
    return found;
}

void footholds_at(const BaseFaces& base, std::int32_t vertex, std::vector<Foothold>& out) {
    out.clear();
    for (const std::int32_t face : base.adjacency().faces_around(vertex)) {
        if (base.is_moving(face)) {
            out.push_back({face, walls_at_corner(corner_of(base.face(face).corners, vertex))});
        }
    }
}

void footholds(const BaseFaces& base, const Place& place, std::vector<Foothold>& out) {
    if (place.kept >= 0) {
        footholds_at(base, place.kept, out);
        return;
    }
    const Enclosure& at = place.in.at;
    out.assign(1, {place.in.face, place.in.walls, at.t, at.t_error});
    if (!shares_walls(base, at)) {
        return;
    }
    const MovingFace& face = base.face(place.in.face);
    const int pillar = pillar_of(place.in.walls);
    if (pillar >= 0) {
        footholds_at(base, face.corners[pillar], out);
        std::for_each(out.begin(), out.end(), [&](Foothold& foothold) {
            foothold.t = at.t;
            foothold.t_error = at.t_error;
        });
        return;
    }
    for (int k = 0; k < 3; ++k) {
        const std::int32_t across = face.across[k];
        if ((place.in.walls & wall_bit(k)) != 0 && across >= 0) {
            out.push_back({across, wall_bit(wall_across(base, place.in.face, k)), at.t, at.t_error});
        }
    }
    std::sort(out.begin(), out.end(), [](const Foothold& a, const Foothold& b) { return a.face < b.face; });
}

Enclosure coordinates_in(const BaseFaces& base, const Place& place, std::int32_t face, const Vec3& q) {
    const MovingFace& wanted = base.face(face);
    if (place.kept >= 0) {
        return {Vec3::Unit(corner_of(wanted.corners, place.kept)), 0.0, 0.0, 0.0};
    }
    if (place.in.face == face) {
        return place.in.at;
    }
    Enclosure there = place.in.at;
    there.alpha = carried_over(there.alpha, base.face(place.in.face).corners, wanted.corners);
    return enclose(wanted.triangle, q, there.alpha, there.t).value_or(there);
}

double displacement(const BaseFaces& base, const Place& place) {
    if (place.kept >= 0) {
        return 0.0;
    }
    const BaseTriangle& triangle = base.face(place.in.face).triangle;
    const Vec3& alpha = place.in.at.alpha;
    // Adding zero turns the -0 of a point below a flat face into 0.
    return 0.0 +
           place.in.at.t * (alpha[0] * triangle.d[0] + alpha[1] * triangle.d[1] + alpha[2] * triangle.d[2]).norm();
}

} // namespace foldless::verification
