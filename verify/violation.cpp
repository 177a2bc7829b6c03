#include <foldless/verify/verify.h>

#include <numeric>

namespace foldless {

std::string_view name(Violation violation) {
    switch (violation) {
    case Violation::topology: return "topology";
    case Violation::kept_vertex: return "kept_vertex";
    case Violation::border: return "border";
    case Violation::jacobian: return "jacobian";
    case Violation::no_preimage: return "no_preimage";
    case Violation::several_preimages: return "several_preimages";
    case Violation::normal_condition: return "normal_condition";
    case Violation::orientation: return "orientation";
    case Violation::trace: return "trace";
    case Violation::interior_sample: return "interior_sample";
    case Violation::base_ray: return "base_ray";
    case Violation::pillar: return "pillar";
    case Violation::degree: return "degree";
    case Violation::overlap: return "overlap";
    }
    return "unknown";
}

std::string_view name(Level level) {
    switch (level) {
    case Level::vertices: return "vertices";
    case Level::surface: return "surface";
    }
    return "unknown";
}

std::size_t VerifyResult::violation_total() const {
    return std::accumulate(violations.begin(), violations.end(), std::size_t(0));
}

} // namespace foldless
