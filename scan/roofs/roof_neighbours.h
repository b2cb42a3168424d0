// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/roofs/roof_town.h"

namespace ilot::scan {

// Returns whether a roof or wall of one building is so close to the plane of one of the other, with almost the same
// direction, that the two cannot be distinguished, although they are not in the same plane. The buildings must share a
// frame. They may be the same building.
bool doubtful(const RoofBuilding& a, const RoofBuilding& b);

// Numbers the planes of all faces except the floors. Coplanar faces share one plane where they meet, if their buildings
// follow each other in the town.
void number_planes(RoofTown& town);

}  // namespace ilot::scan
