// SPDX-License-Identifier: Apache-2.0
// What is hatched on a plan: parts of the wall that nobody saw.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// The holes that are no part of an opening, what openings leave of the others where they take less than half of them,
// and the parts that no ray is known to have crossed, where a square of `least_size` has room. Then what else is bare
// below the highest cell of the wall in its column, beside openings or as a part of a hole that is seen otherwise,
// where a square of four cells has room too. `cells` are as the rays show them; `silent` marks those that count as
// crossed without an echo. O(cells x openings).
std::vector<UnseenArea> unseen_areas(const std::vector<WallHole>& holes, const std::vector<FoundRectangle>& found,
                                     const WallCells& cells, const std::vector<bool>& silent, double least_size);

// The same above the highest cell of the wall in each column, as far as the outline of the wall goes: there it was
// drawn to a height at which it was not seen. Cells in the boxes of `drawn` are left out. O(cells x (corners + boxes)).
std::vector<UnseenArea> unseen_above_wall(const WallCells& cells, const std::vector<Place2>& outline,
                                          const std::vector<Box2>& drawn, double least_size);

}  // namespace ilot
