/// \file
/// Devices and scenes of Embree, which are released when they are left.
#pragma once

#include <memory>

struct RTCDeviceTy;
struct RTCGeometryTy;
struct RTCSceneTy;

namespace foldless {

struct ReleaseEmbree {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
    void operator()(RTCGeometryTy* geometry) const;
};

using EmbreeDevice = std::unique_ptr<RTCDeviceTy, ReleaseEmbree>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseEmbree>;
using EmbreeGeometry = std::unique_ptr<RTCGeometryTy, ReleaseEmbree>;

/// A device that reads no files of the user's and has no threads of its own.
/// \throws std::bad_alloc, or std::runtime_error where Embree cannot run
[[nodiscard]] EmbreeDevice embree_device();

/// The last call failed. \throws std::bad_alloc, std::runtime_error
void require_no_error(const EmbreeDevice& device);

/// Builds a robust hierarchy over the geometry: rounding leaves out no face that a ray meets.
/// Time O(n log n), on the threads of the arena in which it is called. \throws as embree_device()
[[nodiscard]] EmbreeScene embree_scene(const EmbreeDevice& device, const EmbreeGeometry& geometry);

} // namespace foldless
