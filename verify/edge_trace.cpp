#include <foldless/verify/edge_trace.h>

#include <foldless/verify/place.h>

namespace foldless::verification {
namespace {

/// s grows along a trace and a line meets a wall twice at most, so that it ends; few lines pass this many walls.
constexpr std::size_t most_crossings = 100000;

} // namespace

std::optional<std::vector<WallCrossing>> trace(const BaseFaces& base, const ScanLine& line, const FacePosition& start,
                                               const FacePosition& end) {
    std::vector<WallCrossing> crossings;
    FacePosition here = start;
    while (crossings.size() < most_crossings) {
        const MovingFace& face = base.face(here.face);
        if (!face.is_fold_free()) {
            return std::nullopt;
        }
        const Passage passage = follow_line(face.triangle, line, here.at, here.face == end.face ? &end.at : nullptr);
        if (passage.kind == Passage::Kind::ends) {
            return crossings;
        }
        const std::int32_t next = passage.kind == Passage::Kind::leaves ? face.across[passage.wall] : -1;
        if (next < 0 || within(passage.t, face.range) == Sign::negative ||
            within(passage.t, base.face(next).range) == Sign::negative) {
            return std::nullopt;
        }
        crossings.push_back({here.face, passage.wall, next, passage.t, line});
        here = {next, {passage.t, wall_bit(wall_across(base, here.face, passage.wall))}};
    }
    return std::nullopt;
}

} // namespace foldless::verification
