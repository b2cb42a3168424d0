// SPDX-License-Identifier: Apache-2.0
// What was found beside a wall is no part of its plan.
#pragma once
#include <vector>

#include "engine/products/facades/elements/regular_facade.h"
#include "engine/products/facades/openings/silent_holes.h"

namespace ilot {

// Drops relief of which most lies beyond an end of the wall, and relief below its foot: that of a neighbour, which has a
// plan of its own, or a kerb. Openings and their leaves stay, since a wall may end too early; so do parts of the house
// above and below the wall (eaves, recesses and protrusions). O(n).
void drop_elements_outside(const Box2& wall, std::vector<ElementCandidate>& candidates);

// Cuts areas at the box of the wall, and drops those of which nothing wider than their error is left. O(corners).
void cut_at_wall(const Box2& wall, std::vector<UnseenArea>& areas);

}  // namespace ilot
