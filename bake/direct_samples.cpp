#include <foldless/bake/direct_samples.h>

namespace foldless {

FaceSamples direct_samples(const BaseMesh& base, const ScanRays& rays, const SurfaceMap& map,
                           const LatticeOnFace& where) {
    if (map.frozen[where.face]) {
        return frozen_samples(base, rays.scan(), map, where);
    }
    const BaseTriangle triangle = base_triangle(base, where.face, where.first);
    FaceSamples samples(where.lattice, map.ranges[where.face]);
    for (int j = 0; j <= where.lattice.rows; ++j) {
        for (int i = 0; i <= where.lattice.last_column(j); ++i) {
            const RayPassage passed = rays.passage(SampleLine(triangle, where.lattice.weights(i, j)), samples.range);
            samples.at(i, j) = passed.point;
            samples.contested += passed.is_contested ? 1 : 0;
        }
    }
    return samples;
}

} // namespace foldless
