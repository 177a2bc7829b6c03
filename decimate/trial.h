/// \file
/// What accepting a patch would mean.
#pragma once

#include <foldless/decimate/scratch.h>
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
    /// Forgets the places and the scan faces, which may take much room.
    void clear();

    std::vector<NewFace> faces;   ///< one per face of the patch that comes
    std::vector<NewPlace> places; ///< every scan vertex on the patch that is not kept
    std::size_t retested = 0;     ///< inversions asked
    bool vertices_pass = false;   ///< each has a place, with N.n > 0; not with constant directions
};

inline void Trial::clear() {
    for (NewFace& face : faces) {
        clear_scratch(face.scan_faces);
    }
    clear_scratch(places);
    retested = 0;
    vertices_pass = false;
}

} // namespace foldless
