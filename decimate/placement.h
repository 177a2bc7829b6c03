/// \file
/// Where the surviving vertex of a collapse may go.
#pragma once

#include <foldless/decimate/collapse.h>
#include <foldless/decimate/decimate.h>
#include <foldless/decimate/quadric.h>

#include <vector>

namespace foldless {

/// A place for the surviving vertex, already rounded to what the file stores.
struct Candidate {
    Vec3 position;
    std::int32_t at; ///< the base vertex whose place it is, or -1
    double error;    ///< of the quadric
    /// The vertex at that place also keeps its displacement direction, so the faces around it stay as they are, but for
    /// those around the other end.
    bool keeps_direction;
};

/// What decides the candidates of one collapse.
struct PlacementContext {
    const BaseSurface* base;
    Collapse collapse;
    Quadric quadric;
    Vec3 origin;         ///< of the quadric
    bool stays_is_fixed; ///< the only candidate is then its place
    bool float32;        ///< positions are rounded to float32 values
    bool keep_direction; ///< whether an end of the edge may keep its direction
    double good_enough;  ///< mean squared distance up to which such an end goes before all else
};

/// Fills the candidates of the policy, in order of promise: least quadric error first, but before that the ends that
/// keep their direction where they are good enough, because they cost half as much to judge.
void candidates(const PlacementContext& context, Placement placement, std::vector<Candidate>& out);

} // namespace foldless
