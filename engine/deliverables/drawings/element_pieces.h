// SPDX-License-Identifier: Apache-2.0
// The elements of a facade as pieces of its drawing: openings as blocks with what a schedule has of them, lines behind
// other elements as hidden ones.
#pragma once
#include <span>

#include "engine/deliverables/drawings/facade_plan.h"

namespace ilot {

// Draws all elements as draw_element() does, with two differences. Openings whose place is known are blocks. Lines are
// hidden where an element stands 2 cm or more before theirs: of openings only balconies, railings, bays, eaves and
// brackets hide lines, and not those of openings that lie in them altogether. A band, a row of stones or a joint that
// runs across an opening from side to side is hidden within it. Outlines are never hidden. `flat` has one item for each
// element. O(lines times elements near them).
void draw_elements(const Facade& facade, std::span<const FlatElement> flat, double metres_per_unit, Drawing& drawing);

// Returns what the schedule has of an opening: ID, KIND, WIDTH, HEIGHT, SILL and HEAD (heights), DEPTH, all in metres,
// ERROR (mm, the largest of its edges; empty where none is known, "by hand" where a person drew an edge), STATUS.
std::vector<DrawingAttribute> schedule_of(const FacadeElement& element, const FlatElement& flat);

}  // namespace ilot
