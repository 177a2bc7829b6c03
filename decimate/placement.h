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
};

/// What decides the candidates of one collapse.
struct PlacementContext {
    const BaseSurface* base;
    Collapse collapse;
    Quadric quadric;
    Vec3 origin;         ///< of the quadric
    bool stays_is_fixed; ///< the only candidate is then its place
    bool float32;        ///< positions are rounded to float32 values
};

/// Fills the candidates of the policy, in order of promise: least quadric error first.
void candidates(const PlacementContext& context, Placement placement, std::vector<Candidate>& out);

} // namespace foldless
