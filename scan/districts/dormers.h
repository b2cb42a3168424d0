// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/core/rng.h"
#include "scan/roofs/roof_partition.h"

namespace ilot::scan {

// A slope that rises northwards from the eaves at v = 0. Millimetres, slope in sixteenths.
struct Slope {
  Integer from = 0, to = 0;  // u between which it is free
  Integer eave = 0, slope = 0;
  Integer depth = 0;  // from the eaves to the ridge
};

// Adds a row of equal dormers under gable, shed or flat roofs, one to four as there is room; none where the slope is
// too low for them.
void add_dormers(Rng& rng, const Slope& slope, std::vector<Wing>& wings);

}  // namespace ilot::scan
