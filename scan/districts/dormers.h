// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/core/rng.h"
#include "scan/roofs/roof_partition.h"

namespace ilot::scan {

// A slope that rises northwards from the eaves at v = 0. Lengths are millimetres, the slope is in sixteenths.
struct Slope {
  Integer from = 0, to = 0;  // the slope is free between these two u
  Integer eave = 0, slope = 0;
  Integer depth = 0;  // from the eaves to the ridge
};

// Adds a row of equal dormers under gable, shed or flat roofs. There are one to four dormers, as many as there is room
// for. If the slope is too low for dormers, none is added.
void add_dormers(Rng& rng, const Slope& slope, std::vector<Wing>& wings);

}  // namespace ilot::scan
