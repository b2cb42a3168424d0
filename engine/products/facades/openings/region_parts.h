// SPDX-License-Identifier: Apache-2.0
// Openings that a few cells connect past a pier are two.
#pragma once
#include <vector>

#include "engine/products/facades/openings/wall_cells.h"

namespace ilot {

// Cuts a region between two stretches of at least `least` metres in which it takes half of each column (then of each
// row), where it does not in a strip wider than a bar, and wall, or what lies flat on it, takes half of a column there.
// Arched heads, which become narrower and do not become wide again, are not cut. The parts come in order of their
// place. O(cells of the box).
std::vector<CellRegion> parts_of_region(const WallCells& cells, const CellRegion& region, double least);

}  // namespace ilot
