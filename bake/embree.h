/// \file
/// The functions of Embree that this layer calls.
#pragma once

#include <embree3/rtcore.h>

namespace foldless {

/// Embree's library takes 40 megabytes of address space and half of the time in which the program starts, which would
/// be asked of every command. So it is loaded when something is first asked of it, and stays until the program ends.
struct Embree {
    decltype(&rtcNewDevice) new_device;
    decltype(&rtcReleaseDevice) release_device;
    decltype(&rtcGetDeviceError) device_error;

    decltype(&rtcNewScene) new_scene;
    decltype(&rtcReleaseScene) release_scene;
    decltype(&rtcSetSceneFlags) set_scene_flags;
    decltype(&rtcAttachGeometry) attach_geometry;
    decltype(&rtcJoinCommitScene) join_commit_scene;

    decltype(&rtcNewGeometry) new_geometry;
    decltype(&rtcReleaseGeometry) release_geometry;
    decltype(&rtcCommitGeometry) commit_geometry;
    decltype(&rtcSetNewGeometryBuffer) set_new_geometry_buffer;
    decltype(&rtcSetGeometryUserPrimitiveCount) set_user_primitive_count;
    decltype(&rtcSetGeometryUserData) set_user_data;
    decltype(&rtcSetGeometryBoundsFunction) set_bounds_function;
    decltype(&rtcSetGeometryOccludedFilterFunction) set_occluded_filter_function;

    decltype(&rtcPointQuery) point_query;
    decltype(&rtcOccluded1) occluded1;
};

/// \throws std::runtime_error if the library is not there, or not what it was built with; the next call tries again
[[nodiscard]] const Embree& embree();

} // namespace foldless
