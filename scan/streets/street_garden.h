// SPDX-License-Identifier: Apache-2.0
// The gardens behind the houses of a street. They are visible only from above.
#pragma once
#include <cstdint>

#include "scan/streets/street_scan.h"

namespace ilot::scan {

// Gardens are between these distances from the axis of the street.
constexpr double kGardenFrom = kHalfStreet + kHouseDepth + 1.5, kGardenTo = 34;

// Adds bushes, hedges, trees, sheds and garden walls behind the houses, `per_side` in each block and on each side.
// Leaves are crowns that reach down to the ground. Sheds have the class roof, walls the class facade. The function is
// pure: the same seed gives the same result.
void add_gardens(StreetStage& stage, double per_side, std::uint64_t seed);

}  // namespace ilot::scan
