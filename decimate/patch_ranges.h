/// \file
/// The displacements that the scan reaches on a patched surface.
#pragma once

#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/verdict.h>
#include <foldless/predicates/displacement.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// New cells get the hull of what is reached on them; cells outside the patch have a range, which must do.
class PatchRanges {
public:
    /// Nothing is reached yet.
    void reset(PatchedSurface& surface);

    /// `out_of_range` if that is more than the range of a cell that stays.
    [[nodiscard]] Verdict reach(int cell, const Displacement& t);
    /// The pillar of a base vertex inside the scan face: its displacement there is in the range of all cells around it.
    [[nodiscard]] Verdict reach_pillar(std::int32_t vertex, const ScanTriangle& q);

    /// What was reached on a new cell; lo > hi if nothing was.
    [[nodiscard]] const Range& hull(int cell) const { return hulls_[cell]; }
    /// The same rounded outwards to float32; 0 if nothing was reached.
    [[nodiscard]] Range rounded(int cell) const;

private:
    void extend(int cell, Range t);

    PatchedSurface* surface_ = nullptr;
    std::vector<Range> hulls_; ///< per new cell
};

} // namespace foldless
