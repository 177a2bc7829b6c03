#include <foldless/decimate/commit.h>

#include <algorithm>
#include <utility>
#include <vector>

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
        base.set_place(place.scan_vertex, patch.added[place.face].slot, place.alpha, place.t);
    }
}

/// Collapses the halfedge and leaves the corners of every face in the order in which its places count them: of the
/// faces that come the patch's, of those around that stay the one they had. OpenMesh turns them as it needs to.
void collapse_connectivity(BaseSurface& base, const Collapse& collapse, const Patch& patch) {
    std::vector<std::int32_t> around;
    base.faces_around(collapse.stays, around);
    std::vector<std::pair<std::int32_t, std::int32_t>> first_corners;
    for (const std::int32_t f : around) {
        if (!std::binary_search(patch.removed.begin(), patch.removed.end(), f)) {
            first_corners.emplace_back(f, base.corners(f)[0]);
        }
    }
    base.connectivity().collapse(collapse.halfedge);
    for (const auto& [face, corner] : first_corners) {
        base.turn(face, corner);
    }
    for (const PatchFace& face : patch.added) {
        base.turn(face.slot, face.corners[0]);
    }
}

} // namespace

void commit_collapse(BaseSurface& base, const Collapse& collapse, const Patch& patch, const Trial& trial) {
    collapse_connectivity(base, collapse, patch);
    for (const PatchVertex& changed : patch.changed) {
        base.vertex(changed.index) = changed.value;
    }
    commit_faces(base, patch, trial);
    commit_places(base, patch, trial);
}

} // namespace foldless
