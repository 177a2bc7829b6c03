#include <foldless/verify/base_checks.h>

#include <foldless/verify/winding.h>

#include <algorithm>
#include <limits>

namespace foldless::verification {
namespace {

Range common_range(const BaseFaces& base, const Fan& fan) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Range common{-infinity, infinity};
    for (const std::int32_t face : fan.faces) {
        const Range& range = base.face(face).range;
        common = {std::max(common.lo, range.lo), std::min(common.hi, range.hi)};
    }
    return common;
}

/// The edges of the fan at displacement t.
Star star_at(const BaseFaces& base, std::int32_t vertex, const Fan& fan, double t) {
    const auto displaced = [&](std::int32_t v) {
        return DisplacedVertex{base.mesh().positions[v], base.mesh().directions[v]};
    };
    Star star{displaced(vertex), {}, fan.closed, t};
    for (const std::int32_t spoke : base.adjacency().spokes(vertex, fan)) {
        star.ends.push_back(displaced(spoke));
    }
    return star;
}

void check_vertex(const BaseFaces& base, std::int32_t vertex, Findings& findings) {
    const auto moves = [&](std::int32_t face) { return base.is_moving(face); };
    for (const Fan& fan : base.adjacency().fans(vertex, moves)) {
        const Range common = common_range(base, fan);
        const bool is_asked = fan.closed || base.is_kept(vertex);
        if (!is_asked || !(common.lo <= common.hi)) {
            continue;
        }
        if (!goes_round_once(star_at(base, vertex, fan, std::clamp(0.0, common.lo, common.hi)))) {
            findings.add({.violation = Violation::jacobian,
                          .base_face = fan.faces.front(),
                          .position = base.mesh().positions[vertex]});
        }
    }
}

} // namespace

void check_jacobians(const BaseFaces& base, Stages& stages, double share, Findings& findings) {
    stages.for_each(base.moving().size(), share, [&](std::size_t i) {
        const std::int32_t f = base.moving()[i];
        const MovingFace& face = base.face(f);
        if (!face.is_fold_free()) {
            findings.add({.violation = Violation::jacobian, .base_face = f, .position = face.triangle.v[0]});
        }
    });
}

void check_base_windings(const BaseFaces& base, Stages& stages, double share, Findings& findings) {
    if (base.constant_directions()) {
        return;
    }
    stages.for_each(base.mesh().positions.size(), share,
                    [&](std::size_t vertex) { check_vertex(base, static_cast<std::int32_t>(vertex), findings); });
}

} // namespace foldless::verification
