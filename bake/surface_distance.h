/// \file
/// How far two surfaces are from each other: at most, to a proven bound, and on average.
#pragma once

#include <foldless/io/scan.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace foldless {

struct DistanceOptions {
    double bound = 0.0;                   ///< model units, positive: the maxima are known to within it
    std::optional<int> threads;           ///< no value: all cores
    std::function<bool(double)> progress; ///< called with the share done, 0 to 1; false asks to stop
};

/// The distances of the points of one surface to the other, in model units. Every figure is within 2^-44 of the size of
/// the meshes, the longest side of the box around both; `maximum_bound` has that on top and holds as it stands.
struct OneSidedDistance {
    double maximum = 0.0;       ///< reached at `furthest`
    double maximum_bound = 0.0; ///< no point is further; at most `bound` above the maximum
    double rms = 0.0;           ///< the root of the mean square over the area, see below; 0 for a surface without area
    Vec3 furthest = Vec3::Zero(); ///< a point of this surface
    Vec3 nearest = Vec3::Zero();  ///< the point of the other surface nearest to it
};

struct SurfaceDistance {
    bool cancelled = false; ///< then the figures mean nothing
    OneSidedDistance there; ///< of the points of `from` to `to`
    OneSidedDistance back;  ///< of the points of `to` to `from`

    /// The Hausdorff distance, reached.
    [[nodiscard]] double maximum() const { return std::max(there.maximum, back.maximum); }

    /// The Hausdorff distance is not above.
    [[nodiscard]] double maximum_bound() const { return std::max(there.maximum_bound, back.maximum_bound); }

    /// The larger of the two.
    [[nodiscard]] double rms() const { return std::max(there.rms, back.rms); }
};

/// Measures the distances between the surfaces, the unions of all faces; vertices without faces do not count, faces
/// without area do. The meshes need not be manifolds. The maximum is over all points, not over samples: faces near it
/// are split until it is known.
///
/// The mean square is an integral by a rule that is exact for quadratic polynomials, and so wherever the nearest points
/// lie in one plane: 3/4 of the value at the centroid of a triangle and 1/12 of that at each corner. Each face is first
/// split into n^2 equal triangles with the least n for which none has more than 1/50,000 of the area of its surface.
///
/// The result is the same, bit for bit, whatever the number of threads. Several calls may run at once. What the
/// progress callback throws comes out of the call.
///
/// \throws std::invalid_argument for a mesh without faces, a face with a vertex that does not exist, a coordinate of a
/// face that is not finite, less than one thread, or a bound that is not positive and finite or is below 2^-40 of the
/// size of the meshes.
/// Expected time O((F + f) log(F + f)) for F and f faces, and what the bound asks for near the maximum.
[[nodiscard]] SurfaceDistance surface_distance(const Scan& from, const Scan& to, const DistanceOptions& options);

} // namespace foldless
