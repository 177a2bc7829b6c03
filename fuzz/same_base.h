/// \file
/// Whether two base meshes are the same, bit for bit.
#pragma once

#include <foldless/io/base_mesh.h>

#include <cstring>
#include <vector>

namespace foldless::fuzz {

template <class T>
[[nodiscard]] bool is_same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

[[nodiscard]] inline bool is_same(const BaseMesh& a, const BaseMesh& b) {
    return is_same(a.positions, b.positions) && is_same(a.directions, b.directions) &&
           is_same(a.scan_vertex, b.scan_vertex) && is_same(a.faces, b.faces) && is_same(a.ranges, b.ranges) &&
           is_same(a.face_directions, b.face_directions) && a.float32 == b.float32;
}

} // namespace foldless::fuzz
