/// \file
/// Rays that are cast at a scan.
#pragma once

#include <foldless/bake/embree_scene.h>
#include <foldless/bake/face_raster.h>

#include <foldless/io/scan.h>
#include <foldless/predicates/line_past_edge.h>
#include <foldless/predicates/vector.h>

namespace foldless {

/// Where a ray leaves the scan.
struct RayPassage {
    ScanPoint point;           ///< the one at the least |t|, of several there that of the lowest face
    bool is_contested = false; ///< there are others, at other displacements
};

/// A scan as Embree has it: with coordinates of float32, in a box around the faces that is centred and of size 1. What
/// a ray meets is looked at again in doubles, so that float32 decides which faces are met and not where. A ray that
/// passes within rounding of an edge may be told of the face on either side of it.
class ScanRays {
public:
    /// Refers to the scan. Time O(n log n), on the threads of the arena in which it is called; memory O(n).
    /// \throws std::bad_alloc, or std::runtime_error where Embree cannot run
    explicit ScanRays(const Scan& scan);

    [[nodiscard]] const Scan& scan() const { return scan_; }

    /// Among the places of the scan on the line, at displacements in the range, where it passes from behind (N.n > 0).
    /// Any number of threads may ask. Expected time O(log n + places).
    [[nodiscard]] RayPassage passage(const SampleLine& line, Range range) const;

private:
    const Scan& scan_;
    Vec3 centre_;
    double size_; ///< the longest side of the box, model units
    EmbreeDevice device_;
    EmbreeScene scene_;
};

} // namespace foldless
