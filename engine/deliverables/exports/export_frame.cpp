// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/export_frame.h"

#include <cmath>

namespace ilot {

Vec3 export_origin(Vec3 place) {
  constexpr double kRound = 1000;  // CRS units. Choice: people read such numbers, and float32 holds them exactly
  return {kRound * std::floor(place.x / kRound), kRound * std::floor(place.y / kRound), 0};
}

}  // namespace ilot
