#if defined(__x86_64__)
#define FOLDLESS_AVX512
#include <foldless/decimate/prismoid_kernel.h>

namespace foldless::avx512_lanes {

FOLDLESS_KERNEL unsigned cull(const Prismoid::Bounds& bounds, PointBatch& points) {
    return cull_all(bounds, points);
}

} // namespace foldless::avx512_lanes
#endif
