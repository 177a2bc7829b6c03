/// \file
/// What foldless writes: a base mesh with displacement directions and ranges, and the correspondence of the scan.
#pragma once

#include <foldless/io/scan.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// A base mesh as it is stored in a file (docs/formats.md describes it). Every value is the one of the file, exactly.
/// What foldless writes are float32 values, save positions if not `float32`; files of other programs may hold others.
struct BaseMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> directions;          ///< one per vertex, any length; empty with constant face directions
    std::vector<std::int32_t> scan_vertex; ///< the scan vertex that each is, unmoved, or -1; empty if not known
    std::vector<Triangle> faces;
    std::vector<Range> ranges;         ///< one per face, or empty when the file has none
    std::vector<Vec3> face_directions; ///< one per face with constant face directions, else empty
    bool float32 = true;
};

/// Where each scan vertex lies on the base mesh: one entry per scan vertex, in scan order.
struct Correspondence {
    std::vector<std::int32_t> base_face; ///< -1 for a vertex that no face uses
    std::vector<Vec3> alpha;             ///< barycentric coordinates in that face
    std::vector<double> t;               ///< displacement, in units of the interpolated direction
};

} // namespace foldless
