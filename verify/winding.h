/// \file
/// How often a star of edges goes round, seen along a direction.
#pragma once

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <vector>

namespace foldless::verification {

/// The edges of a star in order, as vectors from its centre, and the direction along which it is seen.
struct Star {
    Vec3 direction;
    std::vector<Vec3> edges;
    bool closed = false; ///< the last edge is followed by the first
};

/// Whether the star goes round once (closed) or less than once (open), if consecutive edges turn by angles in (0, pi):
/// positive if no sector but those at the first edge holds that edge's direction, negative if one does, else undecided.
[[nodiscard]] Sign goes_round_once(const Star& star);

} // namespace foldless::verification
