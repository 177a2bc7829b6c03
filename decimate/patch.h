/// \file
/// A local change of the base mesh, before it happens.
#pragma once

#include <foldless/decimate/base_surface.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// A vertex of the base mesh as it would be. Its index may be new.
struct PatchVertex {
    std::int32_t index;
    BaseVertex value;
};

/// A face that would come. A face that stays where it is but whose corners change is one that goes and one that comes.
struct PatchFace {
    Triangle corners;  ///< indices of base vertices, in the orientation of the surface
    std::int32_t slot; ///< the base face whose index it takes over, or -1
};

/// Faces that go and faces that come in their place, with the same rim. Whatever the change is, a collapse, a flip, a
/// split, a relocation or new directions, this is all that the validator knows of it.
struct Patch {
    std::vector<std::int32_t> removed;
    std::vector<PatchFace> added;
    /// Vertices whose position, direction or scan vertex changes. A vertex that goes is listed with scan vertex -1.
    std::vector<PatchVertex> changed;
    void clear() {
        removed.clear();
        added.clear();
        changed.clear();
    }
};

} // namespace foldless
