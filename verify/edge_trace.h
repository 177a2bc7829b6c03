/// \file
/// Following a straight line of the scan from face to face across the walls of the base mesh.
#pragma once

#include <foldless/verify/place.h>

#include <foldless/predicates/vector.h>

#include <cstdint>
#include <vector>

namespace foldless::verification {

/// Where a line passes from one prismoid to the next.
struct WallCrossing {
    std::int32_t face;      ///< the face that is left
    std::int32_t next_face; ///< the face that is entered
    Vec3 alpha;             ///< barycentric coordinates in `face`
    double alpha_error;
    double t;
    double t_error;
};

struct Trace {
    enum class Outcome {
        followed,  ///< the lift of the whole line is known
        lost,      ///< it leaves every range, or meets a border or a frozen face, or does not end where it should
        undecided, ///< rounding hides which
    };
    Outcome outcome = Outcome::lost;
    std::vector<WallCrossing> crossings; ///< in order; of a line that is followed
    FacePlace end{};                     ///< where it ends, if that was not given
};

/// The straight line from `from` to `to`; `error` bounds how far each coordinate may be from the meant line.
struct Line {
    Vec3 from;
    Vec3 to;
    double error = 0.0;
};

/// Follows the line from its start, which lies in one of `starts`, to its end in one of `ends`; an empty `ends` leaves
/// the end open. The lift of a line is unique where J > 0, so at most one sequence of walls leads on; each wall is met
/// at the roots of a quadratic and left at the first that passes outwards within both ranges. A line through a pillar
/// goes on in any face around it that it enters. (docs/certificate.md, E)
///
/// A face is left through its walls only: t is monotone along a lift within a face, so that between two places within
/// the range it stays in the range; that the places belong to one lift is seen from the slope of t at both.
[[nodiscard]] Trace trace(const BaseFaces& base, const Line& line, const std::vector<Foothold>& starts,
                          const std::vector<Foothold>& ends);

} // namespace foldless::verification
