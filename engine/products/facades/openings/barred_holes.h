// SPDX-License-Identifier: Apache-2.0
// Holes in a wall that only the bars of one window divide.
#pragma once
#include <vector>

#include "engine/products/facades/openings/silent_holes.h"
#include "engine/products/facades/openings/wall_cells.h"

namespace ilot {

// Joins holes with straight sides while no more than a bar is between two of them and both end alike along it, and
// gives the regions of what was joined, each with its bars. Beside a single pane of such a window the wall does not go
// on, so that it is the window as a whole about which it must show that rays crossed. Panes beside each other stay
// apart where cells are so large that a pier may look like a bar; one above the other they do not, because the wall
// between two storeys is higher than a bar. O(n^3) in the holes of a wall at worst.
std::vector<CellRegion> regions_over_bars(const std::vector<WallHole>& holes, const WallCells& cells);

}  // namespace ilot
