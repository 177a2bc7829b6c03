#include <foldless/bake/over_face.h>

#include <array>

namespace foldless {
namespace {

/// For each corner of the scan face the corner of the frozen triangle that it is.
std::array<int, 3> corners_of(const BaseTriangle& frozen, const Scan& scan, std::int32_t scan_face) {
    const Triangle& corners = scan.faces[scan_face];
    std::array<int, 3> result{0, 1, 2}; // the same cyclic order, by what frozen means
    while (result[0] < 2 && frozen.v[result[0]] != scan.positions[corners[0]]) {
        result = {result[0] + 1, (result[1] + 1) % 3, (result[2] + 1) % 3};
    }
    return result;
}

} // namespace

BaseTriangle base_triangle(const BaseMesh& base, std::int32_t face, int first) {
    BaseTriangle triangle;
    for (int k = 0; k < 3; ++k) {
        const std::int32_t vertex = base.faces[face][(first + k) % 3];
        triangle.v[k] = base.positions[vertex];
        triangle.d[k] = base.face_directions.empty() ? base.directions[vertex] : base.face_directions[face];
    }
    return triangle;
}

FaceSamples frozen_samples(const BaseMesh& base, const Scan& scan, const SurfaceMap& map, const LatticeOnFace& where) {
    const std::int32_t scan_face = map.over(where.face).front();
    const std::array<int, 3> corner = corners_of(base_triangle(base, where.face, where.first), scan, scan_face);
    FaceSamples samples(where.lattice, {0.0, 0.0});
    for (int j = 0; j <= where.lattice.rows; ++j) {
        for (int i = 0; i <= where.lattice.last_column(j); ++i) {
            const Vec3 alpha = where.lattice.alpha(i, j);
            samples.at(i, j) = {scan_face, 0.0, alpha[corner[1]], alpha[corner[2]]};
        }
    }
    return samples;
}

FaceSamples samples_of(const BaseMesh& base, const Scan& scan, const SurfaceMap& map, const LatticeOnFace& where) {
    if (map.frozen[where.face]) {
        return frozen_samples(base, scan, map, where);
    }
    const BaseTriangle triangle = base_triangle(base, where.face, where.first);
    return rasterise(triangle, map.ranges[where.face], scan, map.over(where.face), where.lattice);
}

} // namespace foldless
