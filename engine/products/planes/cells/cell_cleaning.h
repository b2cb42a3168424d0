// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/cells.h"

namespace ilot {

// Which points of a cell take part in the search for planes [Marchand 2018, II.1]: 1, or 0 = they do not. Density and
// isolation by the 16th neighbour, distance by clusters apart by more than the connectivity. O(n log n).
std::vector<std::uint8_t> kept_points(const NeighbourIndex& index, Cleaning cleaning, const PlaneParams& params);

// The cell with these points alone.
CellPoints only(const CellPoints& cell, const std::vector<std::uint8_t>& kept);

}  // namespace ilot
