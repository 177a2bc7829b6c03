/// \file
/// How the lift of a straight line of the scan goes on in the prismoid of a base triangle, decided exactly: condition E
/// of docs/certificate.md.
#pragma once

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/vector.h>

namespace foldless {

/// What the lift of a line does next in a prismoid.
struct Passage {
    enum class Kind {
        ends,   ///< it reaches its end within this prismoid
        leaves, ///< it goes out through `wall` at `t`
        lost,   ///< it does neither, at any displacement
        pillar, ///< it meets two walls at once, in the pillar of a base vertex: a tie, which refuses
    };
    Kind kind = Kind::lost;
    int wall = -1; ///< opposite this corner
    Displacement t{};
};

/// Follows the lift of the line in the prismoid of the triangle from the point `from` to where it ends, if `end` lies
/// in this prismoid (else null), or leaves. The displacement is monotone along the lift, with dt/ds = w/J (lemma L4),
/// and alpha_k = side_k/w: a wall is met where its quadratic changes sign. Where w = 0 the line lies in one slice, and
/// the walls are met in the order of s.
///
/// The line is not left at its end: from a prismoid in which it does not end the lift goes on straight. s grows along
/// it, and a wall is met twice at most, so that following it ends.
///
/// The range of the prismoid is not looked at: the caller asks whether `t` lies in it, and whether J > 0 on it, which
/// this relies on. Refers to the triangle and to the line.
[[nodiscard]] Passage follow_line(const BaseTriangle& triangle, const ScanLine& line, const PrismoidPoint& from,
                                  const PrismoidPoint* end);

} // namespace foldless
