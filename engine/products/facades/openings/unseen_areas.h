// SPDX-License-Identifier: Apache-2.0
// What is hatched on a plan: parts of the wall that nobody saw.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// The holes that are no part of an opening, what openings leave of the others where they take less than half of them,
// and the parts that no ray is known to have crossed, where a square of `least_size` has room. O(cells).
std::vector<UnseenArea> unseen_areas(const std::vector<WallHole>& holes, const std::vector<FoundRectangle>& found,
                                     const WallCells& cells, double least_size);

}  // namespace ilot
