/// \file
/// Which faces at an edge of many are one surface.
#pragma once

#include <foldless/io/scan.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace foldless {

/// The edges of more faces than this are no surface that someone meant; none of their faces continues another. It also
/// keeps the time linear.
inline constexpr std::size_t most_faces_continued = 8;

/// Pairs of faces at the edge from a to b that continue each other: they run along it in opposite directions, and their
/// normals are closest to one another. The closest pair is taken first, of equal ones that of the first faces; each
/// face is in one pair at most.
[[nodiscard]] std::vector<std::pair<std::int32_t, std::int32_t>>
continuations(const Scan& scan, std::span<const std::int32_t> faces, std::int32_t a, std::int32_t b);

} // namespace foldless
