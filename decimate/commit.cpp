#include <foldless/decimate/commit.h>

#include <cassert>

namespace foldless {
namespace {

void commit_faces(BaseSurface& base, const Patch& patch, const Trial& trial) {
    for (const std::int32_t f : patch.removed) {
        base.face(f).scan_faces.clear();
        base.face(f).first_vertex = -1;
    }
    for (std::size_t n = 0; n < patch.added.size(); ++n) {
        BaseFace& face = base.face(patch.added[n].slot);
        face.range = trial.faces[n].range;
        face.is_scan_face = trial.faces[n].is_scan_face;
        face.scan_faces = trial.faces[n].scan_faces;
    }
    for (const std::int32_t f : patch.removed) {
        if (base.face(f).scan_faces.empty()) {
            base.face(f).scan_faces.shrink_to_fit();
        }
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
        base.vertex(changed.index) = changed.value;
    }
    commit_faces(base, patch, trial);
    commit_places(base, patch, trial);
}

} // namespace foldless
