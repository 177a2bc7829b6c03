#include <foldless/verify/winding.h>

namespace foldless::verification {

bool goes_round_once(const Star& star) {
    const DisplacedVertex& first = star.ends.front();
    const std::size_t sectors = star.ends.size() - 1; // the last sector of a closed star ends at the first edge
    for (std::size_t k = 1; k < sectors; ++k) {
        const bool before = turn_at(star.centre, star.ends[k], first, star.t) == Sign::negative;
        if (!before && turn_at(star.centre, first, star.ends[k + 1], star.t) != Sign::negative) {
            return false; // within the sector, or along one of its sides
        }
    }
    return true;
}

} // namespace foldless::verification
