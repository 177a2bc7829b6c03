/// \file
/// The image of a scan triangle on the base mesh: which walls its border crosses, and which base vertices are inside.
#pragma once

#include <foldless/verify/association.h>

#include <foldless/predicates/vector.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace foldless::verification {

/// What every check of the scan reads.
struct Correspondents {
    const BaseFaces& base;
    const Scan& scan;
    const Association& association;

    [[nodiscard]] ScanTriangle triangle(std::int32_t scan_face) const;
    [[nodiscard]] bool has_places(std::int32_t scan_face) const;
};

/// The image of one scan triangle whose corners have places.
struct ScanImage {
    std::array<bool, 3> edge_is_followed{};          ///< E for the edge from corner k to the next
    std::vector<WallCrossing> crossings;             ///< of all edges that could be followed
    std::optional<std::vector<std::int32_t>> inside; ///< base vertices inside it; nothing if P fails or an edge is lost
    std::vector<std::int32_t> met;                   ///< moving base faces that it meets, each once
};

/// Follows the three edges, and finds the base vertices inside by condition P: those that the parities of the crossings
/// ask for, each of them pierced within the ranges of all faces around it, none kept, frozen or on the border. A base
/// edge strictly between two scan edges that leave a vertex on a pillar counts as crossed once. Exact.
/// (docs/certificate.md, E and P)
[[nodiscard]] ScanImage image_of(const Correspondents& all, std::int32_t scan_face);

} // namespace foldless::verification
