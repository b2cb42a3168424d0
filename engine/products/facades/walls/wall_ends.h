// SPDX-License-Identifier: Apache-2.0
// Ends the walls of a row where their neighbours begin.
#pragma once
#include <vector>

#include "engine/products/facades/walls/wall_groups.h"

namespace ilot {

// Small parts that lie on the plane of a wall by chance may be those of the next house. A wall does not reach beyond
// where the parts of a neighbour with known ends (WallGroup::core0, core1) begin; what both claim is shared.
// Each wall looks only at those around it.
void end_at_neighbours(std::vector<WallGroup>& walls, const WallParams& params);

}  // namespace ilot
