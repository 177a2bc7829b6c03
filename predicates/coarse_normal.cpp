#include <foldless/predicates/coarse_normal.h>

#include <cmath>

namespace foldless {

CoarseNormal::CoarseNormal(const ScanNormal& normal) {
    const ScanNormal unit = normal.normalised();
    if (!(unit.error_for(1) <= 0x1p-31)) {
        return;
    }
    for (int k = 0; k < 3; ++k) {
        parts_[k] = static_cast<std::int16_t>(std::lround(scale * unit.value()[k]));
    }
}

} // namespace foldless
