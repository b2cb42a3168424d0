// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/roofs/roof_town.h"

namespace ilot::scan {

// Whether a roof or wall of one building lies so close to the plane of one of the other, in almost its direction, that
// no one could tell them apart, and yet not on it. The buildings share a frame; they may be the same.
bool doubtful(const RoofBuilding& a, const RoofBuilding& b);

// Numbers the planes of all faces but the floors. Coplanar faces of buildings that follow each other in the town share
// one where they meet.
void number_planes(RoofTown& town);

}  // namespace ilot::scan
