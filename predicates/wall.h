/// \file
/// The wall of a base edge (i, j): the ruled surface of all (1 - lambda) a_i(t) + lambda a_j(t), through which edges of
/// the scan pass from one prismoid to its neighbour.
///
///          a_i(t) ---------- a_j(t)        lambda from 0 at i to 1 at j,
///            |                 |           t upwards along the displacement directions;
///            |      wall       |           seen from the triangle that has i before j in its orientation,
///           v_i ------------- v_j          the wall's normal points outwards.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

namespace foldless {

/// The wall of one base edge, with cached products: a quick answer for the many scan edges that come nowhere near it.
/// follow_line() decides the others.
class Wall {
public:
    /// The wall from corner i = (k + 1) mod 3 to corner j = (k + 2) mod 3 of the triangle: the one opposite corner k.
    Wall(const BaseTriangle& triangle, int opposite);

    /// Whether e.((a_j - a_i)(t) x d(lambda)) certainly has one sign for all lambda in [0, 1] and t in `range`. Then a
    /// straight line along e meets that part of the wall at most once, and passes it in one direction: the map (s,
    /// lambda, t) -> point has this sign as its Jacobian and degree 2, so it is injective (docs/certificate.md). Two
    /// places inside the triangle, with displacements in the range, have then no crossing between them.
    [[nodiscard]] bool is_passed_one_way(const Vec3& e, Range range) const;

private:
    Vec3 w0_, w1_, w2_; ///< the normal is w0 + lambda w1 + t w2
    double size_, spread_;
};

} // namespace foldless
