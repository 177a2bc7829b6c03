#if defined(__x86_64__)
#define FOLDLESS_AVX2
#include <foldless/predicates/batch_inversion_kernel.h>

namespace foldless::avx2_lanes {

FOLDLESS_KERNEL void invert(const InversionTerms& terms, const PointBatch& points, BatchAnswers& answers) {
    solve_all(terms, points, answers);
}

} // namespace foldless::avx2_lanes
#endif
