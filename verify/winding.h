/// \file
/// How often a star of edges goes round, seen along a direction.
#pragma once

#include <foldless/predicates/view_along.h>

#include <vector>

namespace foldless::verification {

/// The edges of a star in order, from its centre to the ends, at displacement t.
struct Star {
    DisplacedVertex centre;
    std::vector<DisplacedVertex> ends;
    bool closed = false; ///< the last edge is followed by the first
    double t = 0;
};

/// Whether the star, seen along the direction of its centre, goes round once (closed) or less than once (open), if
/// consecutive edges turn by angles in (0, pi): whether no sector but those at the first edge holds the direction of
/// that edge. Decided exactly.
[[nodiscard]] bool goes_round_once(const Star& star);

} // namespace foldless::verification
