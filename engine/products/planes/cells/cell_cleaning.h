// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/cells.h"

namespace ilot {

// Which points of a cell take part in the search for planes [Marchand 2018, II.1]: 1 = they do, 0 = they do not.
// Density and isolation are measured with the 16th neighbour. Distance is measured between clusters that are farther
// apart than the connectivity. O(n log n).
std::vector<std::uint8_t> kept_points(const NeighbourIndex& index, Cleaning cleaning, const PlaneParams& params);

// The cell with only these points.
CellPoints only(const CellPoints& cell, const std::vector<std::uint8_t>& kept);

}  // namespace ilot
