/// \file
/// Why a local change of the base mesh is refused.
#pragma once

#include <foldless/predicates/sign.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace foldless {

/// The answer of a guard. `accepted` is the only one that lets a change happen; every other one names its reason.
enum class Verdict {
    accepted,
    link_condition,    ///< the collapse would change the topology
    boundary,          ///< an edge of a locked border, or of a border in a way that trim does not allow
    frozen,            ///< touches a face that only itself can represent
    valence,           ///< combined valence - 1 is not below the limit
    flip,              ///< a new face turns against one that goes
    degenerate,        ///< a new face has no area, or a coordinate that is not finite
    direction,         ///< no direction sees all that it must
    jacobian,          ///< J is not positive on a new prismoid over its range
    no_preimage,       ///< a scan element leaves the patch
    several_preimages, ///< a scan vertex has two places on the patch
    normal_condition,  ///< N.n > 0 fails
    orientation,       ///< the image of a scan triangle is turned over
    out_of_range,      ///< a displacement leaves the range of a face that stays
    overlap,           ///< images of a trimmed border meet, or come too close to tell
    max_displacement,  ///< a displacement is longer than the user allows
    tie,               ///< exactly on a border between two answers that no rule orders
    undecided,         ///< rounding hides the answer
};

inline constexpr std::size_t verdict_count = static_cast<std::size_t>(Verdict::undecided) + 1;

/// What a guard says that asks for a positive sign.
[[nodiscard]] inline Verdict verdict_of(Sign sign, Verdict refusal) {
    if (sign == Sign::positive) {
        return Verdict::accepted;
    }
    return sign == Sign::undecided ? Verdict::undecided : refusal;
}

/// The stable snake_case word of the report.
[[nodiscard]] std::string_view name(Verdict verdict);

/// Whether a scan element between the vertices was refused, or J on a whole prismoid: what tests of vertices miss.
[[nodiscard]] bool is_between_vertices(Verdict verdict);

/// How often each verdict was given, indexed by Verdict.
using VerdictCounts = std::array<std::size_t, verdict_count>;

} // namespace foldless
