#include <foldless/verify/place.h>

namespace foldless::verification {

std::int32_t pillar_of(const BaseFaces& base, std::int32_t face, Walls walls) {
    for (int k = 0; k < 3; ++k) {
        if (walls == walls_at_corner(k)) {
            return base.face(face).corners[k];
        }
    }
    return -1;
}

// Corners i = k + 1 and j = k + 2 of the face lie in its neighbour as j, i: the corner after i is the one opposite.
int wall_across(const BaseFaces& base, std::int32_t face, int k) {
    const MovingFace& from = base.face(face);
    return (corner_of(base.face(from.across[k]).corners, from.corners[(k + 1) % 3]) + 1) % 3;
}

PrismoidPoint on_pillar(const BaseFaces& base, std::int32_t face, std::int32_t vertex, const Displacement& t) {
    return {t, walls_at_corner(corner_of(base.face(face).corners, vertex))};
}

double displacement(const BaseFaces& base, const Place& place, const Vec3& q) {
    const BaseTriangle& triangle = base.face(place.face).triangle;
    const RoundedPlace at = rounded_place(triangle, q, place.at.t);
    // Adding zero turns the -0 of a point below a flat face into 0.
    return 0.0 +
           at.t * (at.alpha[0] * triangle.d[0] + at.alpha[1] * triangle.d[1] + at.alpha[2] * triangle.d[2]).norm();
}

} // namespace foldless::verification
