#include <foldless/verify/scan_windings.h>

#include <foldless/verify/winding.h>

namespace foldless::verification {
namespace {

void check_star(const Correspondents& all, const Adjacency& scan_adjacency, std::int32_t vertex, Findings& findings) {
    const Vec3& centre = all.scan.positions[vertex];
    const auto moves = [&](std::int32_t face) { return !all.base.scan_face_is_frozen(face); };
    for (const Fan& fan : scan_adjacency.fans(vertex, moves)) {
        Star star{all.base.mesh().directions[all.association.places[vertex].kept], {}, fan.closed};
        for (const std::int32_t spoke : scan_adjacency.spokes(vertex, fan)) {
            star.edges.push_back(all.scan.positions[spoke] - centre);
        }
        const Sign once = goes_round_once(star);
        if (once != Sign::positive) {
            findings.add({.violation = once == Sign::negative ? Violation::orientation : Violation::undecided,
                          .scan_vertex = vertex,
                          .position = centre});
        }
    }
}

} // namespace

void check_scan_windings(const Correspondents& all, const Adjacency& scan_adjacency, Stages& stages,
                         Findings& findings) {
    if (all.base.constant_directions()) {
        return;
    }
    stages.for_each(all.scan.positions.size(), 0.0, [&](std::size_t v) {
        if (all.association.places[v].kept >= 0) {
            check_star(all, scan_adjacency, static_cast<std::int32_t>(v), findings);
        }
    });
}

} // namespace foldless::verification
