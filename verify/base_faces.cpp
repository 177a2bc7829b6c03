#include <foldless/verify/base_faces.h>

#include <foldless/predicates/jacobian.h>

namespace foldless::verification {
namespace {

BaseTriangle triangle_of(const BaseMesh& base, std::int32_t face) {
    BaseTriangle triangle;
    for (int k = 0; k < 3; ++k) {
        const std::int32_t vertex = base.faces[face][k];
        triangle.v[k] = base.positions[vertex];
        triangle.d[k] = base.face_directions.empty() ? base.directions[vertex] : base.face_directions[face];
    }
    return triangle;
}

/// The scan face that a base face is, corner by corner, or -1.
std::int32_t same_scan_face(const Meshes& meshes, std::size_t base_face) {
    Triangle wanted;
    for (int k = 0; k < 3; ++k) {
        wanted[k] = meshes.kept.scan_of[meshes.base.faces[base_face][k]];
        if (wanted[k] < 0) {
            return -1;
        }
    }
    const std::int32_t face = meshes.scan_adjacency.face_with(wanted[0], wanted[1]);
    return face >= 0 && corner_of(meshes.scan.faces[face], wanted[2]) >= 0 ? face : -1;
}

bool may_be_frozen(const BaseMesh& base, std::size_t face) {
    return base.ranges.empty() || (base.ranges[face].lo == 0 && base.ranges[face].hi == 0);
}

} // namespace

BaseFaces::BaseFaces(const Meshes& meshes)
    : meshes_(meshes), index_(meshes.base.faces.size(), -1), frozen_scan_faces_(meshes.scan.faces.size(), false) {
    for (std::size_t f = 0; f < meshes.base.faces.size(); ++f) {
        const std::int32_t same = may_be_frozen(meshes.base, f) ? same_scan_face(meshes, f) : -1;
        if (same >= 0) {
            frozen_scan_faces_[same] = true;
        } else {
            index_[f] = static_cast<std::int32_t>(moving_.size());
            moving_.push_back(static_cast<std::int32_t>(f));
        }
    }
    faces_.reserve(moving_.size());
    for (const std::int32_t face : moving_) {
        faces_.push_back(prepare(face));
    }
}

MovingFace BaseFaces::prepare(std::int32_t face) const {
    const BaseMesh& base = meshes_.base;
    const BaseTriangle triangle = triangle_of(base, face);
    const Range stored = base.ranges.empty() ? Range{1, -1} : base.ranges[face];
    MovingFace result{base.faces[face], {}, triangle, stored.lo <= stored.hi ? stored : Range{1, -1}};
    result.jacobian = jacobian_on(triangle, result.range);
    for (int k = 0; k < 3; ++k) {
        const std::int32_t neighbour = meshes_.base_adjacency.neighbour(face, k);
        result.across[k] = neighbour >= 0 && is_moving(neighbour) ? neighbour : -1;
    }
    return result;
}

void BaseFaces::set_range(std::int32_t face, Range range) {
    MovingFace& moving = faces_[index_[face]];
    moving.range = range;
    moving.jacobian = jacobian_on(moving.triangle, range);
}

} // namespace foldless::verification
