// SPDX-License-Identifier: Apache-2.0
// What stands behind the houses of a street, which only those see who look from above.
#pragma once
#include <cstdint>

#include "scan/streets/street_scan.h"

namespace ilot::scan {

// Gardens lie between these distances from the street's axis.
constexpr double kGardenFrom = kHalfStreet + kHouseDepth + 1.5, kGardenTo = 34;

// Adds bushes, hedges, trees, sheds and garden walls behind the houses, so many in each block and on each side. Leaves
// are crowns down to the ground; sheds are of the class roof, walls of facade. Pure: the same for the same seed.
void add_gardens(StreetStage& stage, double per_side, std::uint64_t seed);

}  // namespace ilot::scan
