// SPDX-License-Identifier: Apache-2.0
// What the users of Embree share. Included by sources of this folder alone.
#pragma once
#include <embree3/rtcore.h>

#include <cstddef>

#include "kernels/core/types.h"

namespace ilot {

// Share of the extent by which boxes and radii grow: some eight times the rounding of a float. Embree only culls; what
// it may not lose is decided in doubles.
constexpr double kEmbreeSlack = 0x1p-20;

// One device serves the whole process, as Embree advises; it lives until the end. Throws Error.
RTCDevice embree_device();

// A box from low to high, grown by the slack; what rounding to floats takes is less.
inline RTCBounds embree_bounds(Vec3 low, Vec3 high, double slack) {
  RTCBounds out{};
  out.lower_x = static_cast<float>(low.x - slack);
  out.lower_y = static_cast<float>(low.y - slack);
  out.lower_z = static_cast<float>(low.z - slack);
  out.upper_x = static_cast<float>(high.x + slack);
  out.upper_y = static_cast<float>(high.y + slack);
  out.upper_z = static_cast<float>(high.z + slack);
  return out;
}

// A committed scene of primitives that are its user's own; they stay with the caller, at `user`.
struct EmbreeCallbacks {
  RTCBoundsFunction bounds = nullptr;
  RTCPointQueryFunction point_query = nullptr;
  RTCOccludedFunctionN occluded = nullptr;
};
RTCScene embree_scene(std::size_t primitives, void* user, const EmbreeCallbacks& callbacks);

}  // namespace ilot
