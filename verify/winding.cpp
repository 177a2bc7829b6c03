#include <foldless/verify/winding.h>

#include <foldless/predicates/rounding.h>

namespace foldless::verification {
namespace {

/// The sign of direction.(a x b): which way round it is from a to b. Each of the vectors may be a rounded difference:
/// with four roundings in the cross product and three in the dot product, 12 covers all terms.
Sign turn(const Vec3& direction, const Vec3& a, const Vec3& b) {
    const double error = 12 * unit_roundoff * 2 * sum_norm(direction) * max_norm(a) * max_norm(b);
    return sign_within(direction.dot(a.cross(b)), error);
}

/// Whether the direction `edge` lies in the closed sector from a to b, which is less than half a turn.
Sign holds(const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& edge) {
    const Sign after = turn(direction, a, edge);
    const Sign before = turn(direction, edge, b);
    if (after == Sign::negative || before == Sign::negative) {
        return Sign::negative;
    }
    const bool certain = after == Sign::positive && before == Sign::positive;
    return certain ? Sign::positive : Sign::undecided;
}

} // namespace

Sign goes_round_once(const Star& star) {
    const std::size_t sectors = star.edges.size() - 1; // the last sector of a closed star ends at the first edge
    bool undecided = false;
    for (std::size_t k = 1; k < sectors; ++k) {
        const Sign sign = holds(star.direction, star.edges[k], star.edges[k + 1], star.edges[0]);
        if (sign == Sign::positive) {
            return Sign::negative;
        }
        undecided = undecided || sign != Sign::negative;
    }
    return undecided ? Sign::undecided : Sign::positive;
}

} // namespace foldless::verification
