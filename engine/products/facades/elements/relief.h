// SPDX-License-Identifier: Apache-2.0
// What stands out of the wall: sills, bands, balconies, bulges.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

struct ReliefParams {
  double least_size = 0.03;   // metres; nothing narrower is drawn
  double least_depth = 0.01;  // metres before the wall
  double least_fill = 0.5;    // share of its rectangle that its points must cover
};

// The planes parallel to the wall and before it, each as the rectangle that ends at its sides; pieces of one, on one
// plane and in line, are joined where nothing was seen between them. By id of the first piece. O(n log n).
std::vector<FoundRectangle> find_relief(const RaySamples& samples, const ReliefParams& params = {});

// The stones of a wall that joints part into pieces: of the wall's segments, cut at joints that go through them, those
// that fill their rectangle, where there are at least four. Ordered as above.
std::vector<FoundRectangle> find_stones(const RaySamples& samples);

// Leaves out stones that reach into an opening (a course between two bands, over which windows go on), and all of them
// where fewer than four are left. O(stones x openings).
void drop_pierced_stones(const std::vector<FoundRectangle>& openings, std::vector<FoundRectangle>& stones);

}  // namespace ilot
