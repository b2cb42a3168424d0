// SPDX-License-Identifier: Apache-2.0
// Shared by the users of Embree. Only sources of this folder include it.
#pragma once
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kernels/core/types.h"

namespace ilot {

// Share of the extent by which boxes and radii are enlarged: about eight times the rounding of a float. Embree only
// excludes candidates; everything that it must not lose is decided in doubles.
constexpr double kEmbreeSlack = 0x1p-20;

// Returns the one device of the process, as Embree advises; it exists until the process ends. Throws Error.
RTCDevice embree_device();

// Returns a box from low to high, enlarged by the slack; the rounding to floats is smaller than that.
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

// A committed scene of user-defined primitives; they stay with the caller, at `user`.
struct EmbreeCallbacks {
  RTCBoundsFunction bounds = nullptr;
  RTCPointQueryFunction point_query = nullptr;
  RTCOccludedFunctionN occluded = nullptr;
};
RTCScene embree_scene(std::size_t primitives, void* user, const EmbreeCallbacks& callbacks);

inline double largest(Vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace ilot
