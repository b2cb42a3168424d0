// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/model/building.h"
#include "scan/districts/district.h"

namespace ilot::scan {

// Returns a house of the cell as a closed solid in world coordinates. It consists of the faces of the house and its
// floor, which lies on the ground. Plane p of the cell gets the id first_plane + p, and house h of the cell gets the id
// first_building + h.
Building house_model(const Cell& cell, std::uint32_t house, std::uint32_t first_plane, std::uint32_t first_building);

}  // namespace ilot::scan
