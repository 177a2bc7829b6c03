#include <foldless/bake/embree.h>

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace foldless {
namespace {

[[noreturn]] void fail() {
    const char* reason = dlerror();
    throw std::runtime_error(std::string("Embree cannot be loaded: ") + (reason != nullptr ? reason : "no reason"));
}

template <class Function>
void find(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(library, name)); // what POSIX says of dlsym()
    if (function == nullptr) {
        fail();
    }
}

Embree loaded() {
    void* library = dlopen(FOLDLESS_EMBREE_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        fail();
    }
    Embree functions{};
    find(library, "rtcNewDevice", functions.new_device);
    find(library, "rtcReleaseDevice", functions.release_device);
    find(library, "rtcGetDeviceError", functions.device_error);
    find(library, "rtcNewScene", functions.new_scene);
    find(library, "rtcReleaseScene", functions.release_scene);
    find(library, "rtcSetSceneFlags", functions.set_scene_flags);
    find(library, "rtcAttachGeometry", functions.attach_geometry);
    find(library, "rtcJoinCommitScene", functions.join_commit_scene);
    find(library, "rtcNewGeometry", functions.new_geometry);
    find(library, "rtcReleaseGeometry", functions.release_geometry);
    find(library, "rtcCommitGeometry", functions.commit_geometry);
    find(library, "rtcSetNewGeometryBuffer", functions.set_new_geometry_buffer);
    find(library, "rtcSetGeometryUserPrimitiveCount", functions.set_user_primitive_count);
    find(library, "rtcSetGeometryUserData", functions.set_user_data);
    find(library, "rtcSetGeometryBoundsFunction", functions.set_bounds_function);
    find(library, "rtcSetGeometryOccludedFilterFunction", functions.set_occluded_filter_function);
    find(library, "rtcPointQuery", functions.point_query);
    find(library, "rtcOccluded1", functions.occluded1);
    return functions;
}

} // namespace

const Embree& embree() {
    static const Embree functions = loaded();
    return functions;
}

} // namespace foldless
