// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/streets/ground/ground.h"

namespace ilot {

struct ArtefactParams {
  double least_height = 0.1;  // metres above the ground around
  double ring_reach = 5;      // metres in which the ring around the ground looks for the local ground height
  double highest_kerb = 0.3;  // metres; lower plateaus
  double least_plateau = 1;   // of so many square metres are pavement
};

}  // namespace ilot
