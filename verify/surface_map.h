/// \file
/// What a verification knows of the map from the scan to the base mesh, for those who go on with it.
#pragma once

#include <foldless/verify/verify.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// Which scan faces lie over each base face. Exact where the verification is certified at level `surface`: then every
/// point of a base face that the scan covers belongs to a point of one of these, and of no other scan face.
struct SurfaceMap {
    std::vector<std::size_t> first;       ///< of each base face, into scan_faces; one more than base faces
    std::vector<std::int32_t> scan_faces; ///< ascending for each base face; of a frozen face the one that it is
    std::vector<Range> ranges;            ///< of each base face: those of the mesh, or those that it needs
    std::vector<bool> frozen;             ///< of each base face: it is a scan face, in place

    [[nodiscard]] std::span<const std::int32_t> over(std::int32_t base_face) const {
        return {scan_faces.data() + first[base_face], scan_faces.data() + first[base_face + 1]};
    }
};

struct MappedSurface {
    VerifyResult certificate;
    SurfaceMap map; ///< empty if cancelled
};

/// As verify(), which it calls, and keeps the map. Where there are violations the map is incomplete.
///
/// \throws as verify(). Memory: 4 bytes for each pair of a base face and a scan face over it, twice that while at work.
[[nodiscard]] MappedSurface map_surface(const BaseMesh& base, const Scan& scan, const VerifyOptions& options = {});

} // namespace foldless
