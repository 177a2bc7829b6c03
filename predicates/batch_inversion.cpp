#include <foldless/predicates/batch_inversion.h>

#include <foldless/predicates/batch_inversion_kernel.h>

namespace foldless {

#if defined(__x86_64__)
namespace avx2_lanes {
void invert(const InverseDisplacement::Terms& terms, const PointBatch& points, BatchAnswers& answers);
}
namespace avx512_lanes {
void invert(const InverseDisplacement::Terms& terms, const PointBatch& points, BatchAnswers& answers);
}
#endif

BatchInversion::BatchInversion(const InverseDisplacement& inverse, const PointBatch& points, InstructionSet set)
    : inverse_(&inverse), points_(&points) {
    const InverseDisplacement::Terms& terms = inverse.terms();
    switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512: avx512_lanes::invert(terms, points, answers_); break;
    case InstructionSet::avx2: avx2_lanes::invert(terms, points, answers_); break;
#endif
    default: scalar_lanes::solve_all(terms, points, answers_);
    }
}

Preimages BatchInversion::preimages(int k) const {
    const bool is_decided = ((answers_.none | answers_.single) >> k & 1U) != 0;
    return is_decided ? decided(k) : inverse_->preimages(points_->point(k), points_->range(k));
}

Preimages BatchInversion::decided(int k) const {
    Preimages result;
    if ((answers_.single >> k & 1U) != 0) {
        result.kind = Preimages::Kind::finite;
        result.push_back(preimage(k));
    }
    return result;
}

} // namespace foldless
