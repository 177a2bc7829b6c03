/// \file
/// What the next passage of a line must be, as the oracle has it.
#pragma once

#include "prismoid_oracle.h"
#include "prismoid_samples.h"

#include <foldless/predicates/prismoid_line.h>
#include <foldless/predicates/prismoid_point.h>

#include <optional>
#include <string>

namespace foldless {

/// The number of the lowest wall.
inline int lowest(Walls walls) {
    return (walls & 1U) != 0 ? 0 : (walls & 2U) != 0 ? 1 : 2;
}
inline bool is_one(Walls walls) {
    return walls == wall_bit(lowest(walls));
}

/// What the oracle knows of a line in a prismoid: where it leaves, and where its end is, if that is in there.
struct TruePassage {
    Range range;
    std::optional<oracle::Exit> exit;
    std::optional<oracle::Root> end;
};

/// What is wrong with the passage; empty if nothing is.
inline std::string disagreement(const Passage& passage, const TruePassage& truth) {
    using Kind = Passage::Kind;
    const auto& [range, exit, end] = truth;
    if (end && (!exit || exit->past_end >= 0)) {
        return passage.kind == Kind::ends && is_root(passage.t, *end) ? "" : "the line ends here";
    }
    if (!exit) { // lost, or a root beyond what the oracle looks at
        const bool is_beyond = passage.kind == Kind::lost || within(passage.t, range) == Sign::negative;
        return is_beyond ? "" : "the line does not leave within the range";
    }
    if (exit->past_end > 0 && passage.kind == Kind::lost) {
        return ""; // as good: there is no such point of the line
    }
    const bool is_tie = !is_one(exit->at_start ? exit->out : exit->zero);
    if (passage.kind != (is_tie ? Kind::pillar : Kind::leaves)) {
        return is_tie ? "the line meets a pillar" : "the line leaves through one wall";
    }
    if (passage.wall < 0 || (exit->out & wall_bit(passage.wall)) == 0) {
        return "the line leaves through another wall";
    }
    return is_root(passage.t, exit->t) ? "" : "the line leaves at another displacement";
}

} // namespace foldless
