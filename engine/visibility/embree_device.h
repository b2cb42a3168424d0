// SPDX-License-Identifier: Apache-2.0
// What the users of Embree share. Included by sources of this folder alone.
#pragma once
#include <embree3/rtcore.h>

#include <cstddef>

namespace ilot {

// Share of the extent by which boxes and radii grow: some eight times the rounding of a float. Embree only culls; what
// it may not lose is decided in doubles.
constexpr double kEmbreeSlack = 0x1p-20;

// One device serves the whole process, as Embree advises; it lives until the end. Throws Error.
RTCDevice embree_device();

// A committed scene of primitives that are its user's own; they stay with the caller, at `user`.
struct EmbreeCallbacks {
  RTCBoundsFunction bounds = nullptr;
  RTCPointQueryFunction point_query = nullptr;
  RTCOccludedFunctionN occluded = nullptr;
};
RTCScene embree_scene(std::size_t primitives, void* user, const EmbreeCallbacks& callbacks);

}  // namespace ilot
