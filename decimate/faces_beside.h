/// \file
/// The faces around a patch, which stay: that no scan vertex is on both.
#pragma once

#include <foldless/decimate/cell_places.h>
#include <foldless/decimate/patch_image.h>
#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/verdict.h>
#include <foldless/io/scan.h>

#include <vector>

namespace foldless {

/// Asks what the new cells and those beside the patch have to do with each other, once the new ranges are known.
class FacesBeside {
public:
    explicit FacesBeside(const Scan& scan) : scan_(&scan) {}

    /// `several_preimages` if a scan vertex on a new cell lies in the prismoid of a cell beside the patch that shares a
    /// corner, or the other way round. `tie` if a scan vertex beside the patch lies on the rim where the new cell is a
    /// scan face that represents itself: such a wall has one side.
    [[nodiscard]] Verdict test(PatchedSurface& surface, const std::vector<NewLift>& lifts);

private:
    [[nodiscard]] Verdict test_frozen_walls() const;
    [[nodiscard]] Verdict test_wall(int outer, int k) const;
    [[nodiscard]] Verdict test_new_places_in(int outer, const std::vector<NewLift>& lifts) const;
    void prepare_new_cells();
    [[nodiscard]] Verdict test_vertices_of(int outer) const;

    const Scan* scan_;
    PatchedSurface* surface_ = nullptr;
    std::vector<int> beside_;      ///< cells beside the patch
    std::vector<CellPlaces> here_; ///< the new cells that move
    Box around_here_;              ///< around all of them
};

} // namespace foldless
