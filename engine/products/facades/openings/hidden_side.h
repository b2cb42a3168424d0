// SPDX-License-Identifier: Apache-2.0
// What is known of a side of an opening that something hides.
#pragma once
#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/sides/located_edge.h"

namespace ilot {

// Metres beyond a side of a box until the wall is seen on half of the lines across the side; lines on which no wall is
// seen end with the cells. An opening with this side does not go on beyond. Only solid cells end the search: relief
// before the wall, shallow places and other openings do not. O(cells beyond).
double wall_beyond(const WallCells& cells, const Box2& box, Side side);

}  // namespace ilot
