/// \file
/// Following an edge of the scan from face to face across the walls of the base mesh: condition E.
#pragma once

#include <foldless/verify/base_faces.h>

#include <foldless/predicates/prismoid_line.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace foldless::verification {

/// Where the lift of an edge passes from one prismoid to the next.
struct WallCrossing {
    std::int32_t face; ///< the face that is left
    int wall;          ///< through its wall opposite this corner
    std::int32_t next_face;
    Displacement t;
    ScanLine line;
};

/// A point of a moving face.
struct FacePosition {
    std::int32_t face;
    PrismoidPoint at;
};

/// The walls that the lift of the line crosses, in order, from the place of its one end to that of the other; nothing
/// if it leaves a range, meets a border, a frozen face or a pillar, or ends elsewhere. The lift is unique where J > 0;
/// no trace enters a face that folds. A line through a wall goes on in the face across; the line may meet a wall twice.
/// Exact. (docs/certificate.md, E)
[[nodiscard]] std::optional<std::vector<WallCrossing>> trace(const BaseFaces& base, const ScanLine& line,
                                                             const FacePosition& start, const FacePosition& end);

} // namespace foldless::verification
