#include <foldless/verify/topology_checks.h>

#include <foldless/io/defects.h>

namespace foldless::verification {
namespace {

/// Calls visit(from, to, face) for every side of every face.
template <class Visit>
void for_each_side(const std::vector<Triangle>& faces, Visit visit) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            visit(faces[f][k], faces[f][(k + 1) % 3], static_cast<std::int32_t>(f));
        }
    }
}

/// Whether the half-edge is a side of a border face in the other mesh too. `other_of` gives the same vertex there.
bool is_border_there(const std::vector<std::int32_t>& other_of, const Adjacency& there, std::int32_t from,
                     std::int32_t to) {
    const std::int32_t a = other_of[from];
    const std::int32_t b = other_of[to];
    return a >= 0 && b >= 0 && there.face_with(a, b) >= 0 && there.face_with(b, a) < 0;
}

bool borders_match(const std::vector<Triangle>& faces, const Adjacency& here, const std::vector<std::int32_t>& other_of,
                   const Adjacency& there) {
    bool match = true;
    for_each_side(faces, [&](std::int32_t from, std::int32_t to, std::int32_t) {
        if (match && here.face_with(to, from) < 0) {
            match = is_border_there(other_of, there, from, to);
        }
    });
    return match;
}

} // namespace

void check_topology(const BaseMesh& base, const Scan& scan, Findings& findings) {
    const Topology a = inspect(Scan{base.positions, base.faces, base.float32}).topology;
    const Topology b = inspect(scan).topology;
    const bool same = a.components == b.components && a.boundary_loops == b.boundary_loops &&
                      a.euler_characteristic == b.euler_characteristic;
    if (!same) {
        findings.add({.violation = Violation::topology});
    }
}

bool border_is_locked(const Meshes& m) {
    return borders_match(m.base.faces, m.base_adjacency, m.kept.scan_of, m.scan_adjacency) &&
           borders_match(m.scan.faces, m.scan_adjacency, m.kept.base_of, m.base_adjacency);
}

void check_seams(const Meshes& m, const BaseFaces& faces, bool locked, Findings& findings) {
    for_each_side(m.scan.faces, [&](std::int32_t from, std::int32_t to, std::int32_t scan_face) {
        const std::int32_t a = m.kept.base_of[from];
        const std::int32_t b = m.kept.base_of[to];
        const bool is_base_edge =
            a >= 0 && b >= 0 && (m.base_adjacency.face_with(a, b) >= 0 || m.base_adjacency.face_with(b, a) >= 0);
        if (!is_base_edge) {
            return;
        }
        const std::int32_t base_face = m.base_adjacency.face_with(a, b);
        const bool scan_moves = !faces.scan_face_is_frozen(scan_face);
        const bool base_moves = base_face >= 0 && faces.is_moving(base_face);
        if (scan_moves && !base_moves) {
            findings.add({.violation = Violation::border,
                          .scan_face = scan_face,
                          .base_face = base_face,
                          .position = m.scan.positions[from]});
        }
    });
    if (!locked) {
        return;
    }
    for_each_side(m.base.faces, [&](std::int32_t from, std::int32_t to, std::int32_t base_face) {
        const std::int32_t across = m.base_adjacency.face_with(to, from);
        if (!faces.is_moving(base_face) || across < 0 || faces.is_moving(across)) {
            return;
        }
        // The frozen face across is a scan face, so both ends are kept.
        const std::int32_t scan_face = m.scan_adjacency.face_with(m.kept.scan_of[from], m.kept.scan_of[to]);
        if (scan_face < 0 || faces.scan_face_is_frozen(scan_face)) {
            findings.add({.violation = Violation::border,
                          .scan_face = scan_face,
                          .base_face = base_face,
                          .position = m.base.positions[from]});
        }
    });
}

} // namespace foldless::verification
