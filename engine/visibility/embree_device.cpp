// SPDX-License-Identifier: Apache-2.0
#include "engine/visibility/embree_device.h"

#include <string>

#include "engine/error.h"

namespace ilot {

RTCDevice embree_device() {
  // Scenes are small and built while nothing else runs. With more threads each thread takes 5 MB or more of its own
  // memory.
  static const RTCDevice shared = rtcNewDevice("threads=1");
  if (!shared) throw Error("Embree cannot start on this machine; reinstall libembree3");
  return shared;
}

RTCScene embree_scene(std::size_t primitives, void* user, const EmbreeCallbacks& callbacks) {
  const RTCScene scene = rtcNewScene(embree_device());
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT);
  RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(primitives));
  rtcSetGeometryUserData(geometry, user);
  rtcSetGeometryBoundsFunction(geometry, callbacks.bounds, nullptr);
  if (callbacks.point_query) rtcSetGeometryPointQueryFunction(geometry, callbacks.point_query);
  if (callbacks.occluded) rtcSetGeometryOccludedFunction(geometry, callbacks.occluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  const RTCError error = rtcGetDeviceError(embree_device());
  if (error == RTC_ERROR_NONE) return scene;
  rtcReleaseScene(scene);
  throw Error("Embree could not build a scene of " + std::to_string(primitives) + " parts (its error code " +
              std::to_string(static_cast<int>(error)) + "); free memory and try again");
}

}  // namespace ilot
