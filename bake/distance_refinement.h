/// \file
/// The maximal distance of a sampled surface to another, by branch and bound.
#pragma once

#include <foldless/bake/distance_samples.h>

namespace foldless::distances {

/// The largest distance that was reached, and one that no point exceeds.
struct Maximum {
    Sample furthest;
    double upper;
};

/// Splits the faces whose upper bound is above what is reached elsewhere, until no part of them has a bound more than
/// `bound` above it. `share` of all work; no meaning after a cancellation.
///
/// Parts are taken in rounds of a fixed number, those of faces with the largest bounds first, and a round knows only
/// what the rounds before it have reached: the result does not depend on the number of threads. Memory for 16 bytes a
/// face and some thousand parts for each halving of a face. \pre bound > 0
[[nodiscard]] Maximum refined_maximum(const SampledSurface& surface, const std::vector<Triangle>& faces,
                                      const NearestFace& other, double bound, BlockLoop& loop, double share);

} // namespace foldless::distances
