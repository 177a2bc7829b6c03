#include <foldless/verify/scan_windings.h>

#include <foldless/verify/winding.h>

namespace foldless::verification {
namespace {

void check_star(const Correspondents& all, const Adjacency& scan_adjacency, std::int32_t vertex, Findings& findings) {
    const Vec3& centre = all.scan.positions[vertex];
    const auto moves = [&](std::int32_t face) { return !all.base.scan_face_is_frozen(face); };
    for (const Fan& fan : scan_adjacency.fans(vertex, moves)) {
        Star star{{centre, all.base.mesh().directions[all.association.places[vertex].kept]}, {}, fan.closed};
        for (const std::int32_t spoke : scan_adjacency.spokes(vertex, fan)) {
            star.ends.push_back({all.scan.positions[spoke], Vec3::Zero()});
        }
        if (!goes_round_once(star)) {
            findings.add({.violation = Violation::orientation, .scan_vertex = vertex, .position = centre});
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
