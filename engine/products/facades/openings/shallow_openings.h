// SPDX-License-Identifier: Apache-2.0
// Openings whose panes lie only a few centimetres behind the wall.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// Finds the flat regions that lie behind the form of the wall (trend_surface.h) by at least the step that means of
// points show there (wall_means.h), 1.2 cm or more, and no deeper than rays that are known to go through. Where the
// wall bows more than its form follows, a pane is connected with it at a small step, so that larger ones are tried too.
// Each region is looked at once more with the wall about it alone, which is levelled: what lies nearer to the wall than
// to the pane is wall there, in cells that are the larger the less deep the pane is for the scatter of the points, and
// the sides and the head are found as those of any opening. `cells` is the image of the wall; those that rays crossed
// without an echo belong to a region beside them. The order is by step, then from bottom to top, and from left to right
// within a row. O(points).
std::vector<FoundRectangle> find_shallow_openings(const RaySamples& samples, const WallCells& cells,
                                                  const OpeningParams& params);

// Adds shallow openings to others: they replace pieces of themselves, and those beyond which they go on by more than
// the errors of both; they are left out where a larger one was found.
void add_shallow_openings(std::vector<FoundRectangle>&& shallow, std::vector<FoundRectangle>& found);

}  // namespace ilot
