/// \file
/// What is needed to bake one base face.
#pragma once

#include <foldless/bake/face_raster.h>

#include <foldless/io/base_mesh.h>
#include <foldless/verify/surface_map.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// A base face and the samples that are asked for.
struct LatticeOnFace {
    std::int32_t face;
    int first; ///< the corner whose coordinate is alpha_0 of the lattice; the others follow it
    SampleLattice lattice;
};

/// The corners from `first` on, with their directions; with constant face directions that of the face at each.
[[nodiscard]] BaseTriangle base_triangle(const BaseMesh& base, std::int32_t face, int first);

/// The samples of a frozen face, all at t = 0. A frozen face is the scan face itself: its samples stay where they are,
/// though the directions may not see it from in front. \pre the face is frozen
[[nodiscard]] FaceSamples frozen_samples(const BaseMesh& base, const Scan& scan, const SurfaceMap& map,
                                         const LatticeOnFace& where);

/// The samples, each with the point of the scan that it is displaced to, of the scan faces that the map has over the
/// base face.
[[nodiscard]] FaceSamples samples_of(const BaseMesh& base, const Scan& scan, const SurfaceMap& map,
                                     const LatticeOnFace& where);

} // namespace foldless
