/// \file
/// The scan in an order in which what is near in space is near in memory.
#pragma once

#include <foldless/io/scan.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// Another order of the vertices and faces of a scan: the old index of each new one.
///
/// The loop takes edges by length, that is, from all over the scan; each collapse then reads a few dozen vertices and
/// faces around one place. In the order of most scanners these lie in as many cache lines.
struct LocalOrder {
    std::vector<std::int32_t> vertices;
    std::vector<std::int32_t> faces;
};

/// Vertices along a Morton curve through the box around them, faces by their vertices in that order. It does not depend
/// on how the scan is numbered, unless two vertices have the same position. The scan must be free of defects. Time
/// O(n log n).
[[nodiscard]] LocalOrder local_order(const Scan& scan);

/// The scan with its vertices and faces in that order; corners keep theirs within each face. A scan that is moved into
/// the call needs no second one: one array at a time is copied.
[[nodiscard]] Scan in_order(Scan scan, const LocalOrder& order);

/// The scan of which this is in_order().
[[nodiscard]] Scan as_before(Scan scan, const LocalOrder& order);

/// For an order given as the old index of each new one, the new index of each old one.
[[nodiscard]] std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order);

} // namespace foldless
