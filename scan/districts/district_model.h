// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/model/building.h"
#include "scan/districts/district.h"

namespace ilot::scan {

// A house of the cell as a closed solid in world coordinates: its faces and its floor, which lies on the ground. The
// cell's plane p bears the id first_plane + p, its house h the id first_building + h.
Building house_model(const Cell& cell, std::uint32_t house, std::uint32_t first_plane, std::uint32_t first_building);

}  // namespace ilot::scan
