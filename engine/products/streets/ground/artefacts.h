// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/streets/ground/ground.h"

namespace ilot {

struct ArtefactParams {
  double least_height = 0.1;  // metres above the ground around
  double ring_reach = 5;      // metres; the ring around the ground takes the lowest ground within this distance
  double highest_kerb = 0.3;  // metres; greatest height of a plateau that is pavement
  double least_plateau = 1;   // square metres; least area of a plateau that is pavement
};

}  // namespace ilot
