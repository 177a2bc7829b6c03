#include <foldless/bake/embree_scene.h>

#include <foldless/bake/embree.h>

#include <new>
#include <stdexcept>
#include <string>

namespace foldless {
namespace {

/// No files that users of Embree may have in their folders, and no threads of its own.
constexpr const char* configuration = "ignore_config_files=1,start_threads=0,set_affinity=0";

} // namespace

void ReleaseEmbree::operator()(RTCDeviceTy* device) const {
    embree().release_device(device);
}

void ReleaseEmbree::operator()(RTCSceneTy* scene) const {
    embree().release_scene(scene);
}

void ReleaseEmbree::operator()(RTCGeometryTy* geometry) const {
    embree().release_geometry(geometry);
}

void require_no_error(const EmbreeDevice& device) {
    const RTCError error = embree().device_error(device.get());
    if (error == RTC_ERROR_OUT_OF_MEMORY) {
        throw std::bad_alloc();
    }
    if (error != RTC_ERROR_NONE) {
        throw std::runtime_error("Embree fails with error " + std::to_string(error));
    }
}

EmbreeDevice embree_device() {
    EmbreeDevice device(embree().new_device(configuration));
    require_no_error(device);
    return device;
}

EmbreeScene embree_scene(const EmbreeDevice& device, const EmbreeGeometry& geometry) {
    EmbreeScene scene(embree().new_scene(device.get()));
    require_no_error(device);
    embree().set_scene_flags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    embree().commit_geometry(geometry.get());
    embree().attach_geometry(scene.get(), geometry.get());
    embree().join_commit_scene(scene.get()); // on the threads of this arena, where rtcCommitScene() has its own
    require_no_error(device);
    return scene;
}

} // namespace foldless
