// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/cells.h"

namespace ilot {

// How much lower than walls of one storey the highest things of a cloud are, as in clouds that are cut at 2 m above the
// street: 1 where something is higher than `storey` metres, else the height that nearly all is below, divided by it.
// Heights that decide what a wall is are multiplied by it. Reads "highest" and "terrain" of cells.
double height_share(const Cells& cells, double storey);

}  // namespace ilot
