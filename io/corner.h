/// \file
/// Which corner of a face a vertex is, and which way a face runs along an edge.
#pragma once

#include <foldless/io/scan.h>

#include <cstdint>

namespace foldless {

/// Which corner of the face the vertex is: 0, 1 or 2. The face must have it.
[[nodiscard]] inline std::uint32_t place_of(const Triangle& face, std::int32_t vertex) {
    return face[0] == vertex ? 0 : face[1] == vertex ? 1 : 2;
}

/// The number of a corner among all corners of a mesh, 3 face + its place.
[[nodiscard]] inline std::uint32_t corner_of(const Triangle& face, std::int32_t number, std::int32_t vertex) {
    return 3 * static_cast<std::uint32_t>(number) + place_of(face, vertex);
}

/// Whether the face, of three different vertices, runs from a to b.
[[nodiscard]] inline bool runs_along(const Triangle& face, std::int32_t a, std::int32_t b) {
    return (face[0] == a && face[1] == b) || (face[1] == a && face[2] == b) || (face[2] == a && face[0] == b);
}

} // namespace foldless
