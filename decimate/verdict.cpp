#include <foldless/decimate/verdict.h>

namespace foldless {

std::string_view name(Verdict verdict) {
    switch (verdict) {
    case Verdict::accepted: return "accepted";
    case Verdict::link_condition: return "link_condition";
    case Verdict::boundary: return "boundary";
    case Verdict::frozen: return "frozen";
    case Verdict::valence: return "valence";
    case Verdict::flip: return "flip";
    case Verdict::degenerate: return "degenerate";
    case Verdict::direction: return "direction";
    case Verdict::jacobian: return "jacobian";
    case Verdict::no_preimage: return "no_preimage";
    case Verdict::several_preimages: return "several_preimages";
    case Verdict::normal_condition: return "normal_condition";
    case Verdict::orientation: return "orientation";
    case Verdict::out_of_range: return "out_of_range";
    case Verdict::overlap: return "overlap";
    case Verdict::max_displacement: return "max_displacement";
    case Verdict::tie: return "tie";
    case Verdict::undecided: return "undecided";
    }
    return "unknown";
}

bool is_between_vertices(Verdict verdict) {
    switch (verdict) {
    case Verdict::jacobian:
    case Verdict::no_preimage:
    case Verdict::normal_condition:
    case Verdict::out_of_range:
    case Verdict::overlap:
    case Verdict::tie:
    case Verdict::undecided: return true;
    default: return false;
    }
}

} // namespace foldless
