/// \file
/// The shapes that one lattice covers.
#pragma once

#include <foldless/models/place.h>

namespace foldless {

/// A surface over the unit square, perhaps closed in u or v.
struct Sheet {
    Surface surface;
    double aspect; ///< mean length along u over mean length along v: the ratio of the cells that makes them square
    bool wraps_u;
    bool wraps_v;
};

/// About the z axis, radii 1 and 0.4.
[[nodiscard]] Sheet torus();

/// A tube of radius 0.5 around the trefoil ((2 + cos 3t) cos 2t, (2 + cos 3t) sin 2t, sin 3t). The reach of that curve
/// is 0.83 (half the least distance of two strands; the least radius of curvature is 1.43), so the tube is embedded.
[[nodiscard]] Sheet knot();

/// A height field of six sinusoids over the square [-1, 1]^2.
[[nodiscard]] Sheet terrain();

/// A sheet 2 wide whose profile is an S: straight, half a turn back, straight, half a turn forward, straight. Over
/// 1 < x < 2 it lies in three layers 0.3 apart, the middle one facing down, so no displacement of a plane gives it.
[[nodiscard]] Sheet fold();

} // namespace foldless
