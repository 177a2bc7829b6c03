#include <foldless/decimate/commit.h>

#include <cassert>

namespace foldless {
namespace {

void commit_faces(BaseSurface& base, const Patch& patch, const Trial& trial) {
    for (const std::int32_t f : patch.removed) {
        base.clear_face(f);
    }
    for (std::size_t n = 0; n < patch.added.size(); ++n) {
        const Trial::NewFace& face = trial.faces[n];
        base.set_face(patch.added[n].slot, {face.range, face.scan_faces, -1, face.is_scan_face});
    }
}

void commit_places(BaseSurface& base, const Patch& patch, const Trial& trial) {
    for (const Trial::NewPlace& place : trial.places) {
        const PatchFace& face = patch.added[place.face];
        assert(base.corners(face.slot) == face.corners); // OpenMesh leaves the order as it is
        base.set_place(place.scan_vertex, face.slot, place.alpha, place.t);
    }
}

} // namespace

void commit_collapse(BaseSurface& base, const Collapse& collapse, const Patch& patch, const Trial& trial) {
    base.connectivity().collapse(collapse.halfedge);
    for (const PatchVertex& changed : patch.changed) {
        base.set_vertex(changed.index, changed.value);
    }
    base.drop_vertex(collapse.gone);
    commit_faces(base, patch, trial);
    commit_places(base, patch, trial);
}

} // namespace foldless
