// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/embree_device.h"

#include <fmt/format.h>

#include <limits>

#include "engine/error.h"

namespace ilot::scan {

RTCDevice embree_device() {
  static const RTCDevice shared = rtcNewDevice(nullptr);
  if (!shared) throw Error("Embree cannot start on this machine; reinstall libembree3");
  return shared;
}

void set_embree_bounds(const Box3<Vec3>& box, Vec3 anchor, double margin, RTCBounds& out) {
  const Vec3 low = box.min - anchor, high = box.max - anchor;
  const auto by = static_cast<float>(margin);
  out.lower_x = static_cast<float>(low.x) - by;
  out.lower_y = static_cast<float>(low.y) - by;
  out.lower_z = static_cast<float>(low.z) - by;
  out.upper_x = static_cast<float>(high.x) + by;
  out.upper_y = static_cast<float>(high.y) + by;
  out.upper_z = static_cast<float>(high.z) + by;
}

RTCRayHit embree_query(const Ray& ray, Vec3 anchor) {
  const Vec3 origin = ray.origin - anchor;
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin.x);
  query.ray.org_y = static_cast<float>(origin.y);
  query.ray.org_z = static_cast<float>(origin.z);
  query.ray.dir_x = static_cast<float>(ray.direction.x);
  query.ray.dir_y = static_cast<float>(ray.direction.y);
  query.ray.dir_z = static_cast<float>(ray.direction.z);
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

void check_embree(const char* what, std::size_t count) {
  const RTCError error = rtcGetDeviceError(embree_device());
  if (error != RTC_ERROR_NONE)
    throw Error(fmt::format("Embree could not build a scene of {} {} (its error code {}); free memory and try again",
                            count, what, static_cast<int>(error)));
}

}  // namespace ilot::scan
