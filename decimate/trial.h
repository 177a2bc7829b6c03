/// \file
/// What accepting a patch would mean.
#pragma once

#include <foldless/predicates/vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foldless {

/// Computed while a patch is judged; commit() writes it.
struct Trial {
    struct NewFace {
        Range range{0.0, 0.0};
        std::vector<std::int32_t> scan_faces;
        bool is_scan_face = false;
    };
    struct NewPlace {
        std::int32_t scan_vertex;
        int face; ///< index of the new face
        Vec3 alpha;
        double t;
    };
    std::vector<NewFace> faces;   ///< one per face of the patch that comes
    std::vector<NewPlace> places; ///< every scan vertex on the patch that is not kept
    std::size_t retested = 0;     ///< inversions asked
    bool vertices_pass = false;   ///< each has a place, with N.n > 0; not with constant directions
};

} // namespace foldless
