// SPDX-License-Identifier: Apache-2.0
// What was found beside a wall is no part of its plan.
#pragma once
#include <vector>

#include "engine/model/facade.h"
#include "engine/products/facades/elements/regular_facade.h"

namespace ilot {

// Drops relief of which most lies beyond an end of the wall, and relief below its foot: that of a neighbour, which has
// a plan of its own, or a kerb. Openings and their leaves stay, since a wall may end too early; so do parts of the
// house above and below the wall (eaves, recesses and protrusions). What stands out of an end of the wall and goes on
// as far as `deepest`, where the search ends, is the wall that meets it there. O(n).
void drop_elements_outside(const Box2& wall, double deepest, std::vector<ElementCandidate>& candidates);

// Cuts what is drawn as not seen or as a possible opening at the box of the outline, drops what is left without width
// or height, and numbers the elements again. To be called when the ends of the outline are known. O(corners).
void cut_unseen_at_outline(Facade& facade, double metres_per_unit);

}  // namespace ilot
