// SPDX-License-Identifier: Apache-2.0
// Openings of one sheet do not overlap.
#pragma once
#include <cstddef>
#include <vector>

#include "engine/products/facades/elements/regular_facade.h"

namespace ilot {

// Where two openings overlap by no more than half of the smaller one, the side of one of them was not found where it
// is: the one with the larger stated error. It becomes `occluded`, and its gap is from the nearest place that its error
// allows to the side of the other opening, so that its row or others of its size can complete it. To be called before
// complete_elements. O(n^2) in the openings.
void open_overlapping_sides(std::vector<ElementCandidate>& candidates);

// Ends openings that overlap still before each other: the side with the larger stated error moves to that of the other
// opening, or both to the middle if nobody saw either. Its error reaches to where it was. To be called when sides are
// complete. O(n^2) in the openings.
void end_before_others(std::vector<ElementCandidate>& candidates);

// Whether a side of the candidate `i`, an opening, would reach into another opening, as far as this was seen, if it
// were at the place `at`. O(n).
bool reaches_into_other(const std::vector<ElementCandidate>& candidates, std::size_t i, Side side, double at);

}  // namespace ilot
