/// \file
/// Small meshes from their faces, and what a repair makes of them.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/repair/repair.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace foldless::test {

/// Points of which no three lie on one line, on the curve (i, i^2, i^3); just enough for the faces.
inline Scan mesh(std::vector<Triangle> faces) {
    std::int32_t last = -1;
    for (const Triangle& face : faces) {
        last = std::max(last, *std::max_element(face.begin(), face.end()));
    }
    Scan scan;
    for (std::int32_t i = 0; i <= last; ++i) {
        scan.positions.emplace_back(i, i * i, i * i * i);
    }
    scan.faces = std::move(faces);
    return scan;
}

/// The faces with every vertex raised by so much.
inline std::vector<Triangle> raised(std::vector<Triangle> faces, std::int32_t by) {
    for (Triangle& face : faces) {
        for (std::int32_t& vertex : face) {
            vertex += by;
        }
    }
    return faces;
}

inline std::vector<Triangle> joined(std::vector<Triangle> faces, const std::vector<Triangle>& more) {
    faces.insert(faces.end(), more.begin(), more.end());
    return faces;
}

inline std::vector<Triangle> inside_out(std::vector<Triangle> faces) {
    for (Triangle& face : faces) {
        std::swap(face[1], face[2]);
    }
    return faces;
}

inline RepairResult repaired(const std::vector<Triangle>& faces) {
    return repair(mesh(faces));
}

inline const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

} // namespace foldless::test
