// SPDX-License-Identifier: Apache-2.0
// Leaves of shutters that stand out of the wall, half open.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"
#include "kernels/geometry/flat.h"

namespace ilot {

// An upright plate that ends at the wall on one side, its hinge.
struct StandingLeaf {
  Place2 hinge, tip;         // along the wall and out of it: v is the distance from the wall here
  double low = 0, high = 0;  // v of its ends
  double error = 0;          // metres, of the hinge
  std::uint64_t points = 0;

  double length() const { return norm(FlatPoint{tip.u - hinge.u, tip.v - hinge.v}); }
};

// Finds the segments of the cloud before the wall that are upright, lean to the wall by ten degrees and more, begin
// within 15 cm of it, and are higher than long and filled. O(points).
std::vector<StandingLeaf> find_standing_leaves(const RaySamples& samples);

// A window between two leaves that stand out of the wall, and the rectangles of leaves before the wall.
struct HalfOpen {
  std::vector<FoundRectangle> windows, leaves;
};

// Two leaves at one height, equally long and as far apart as both reach when they are closed, are those of one window
// where no wall is seen between them; so is one leaf beside an opening of its height. The window then ends at the
// hinges. Openings that lie in such a window are taken from the list, and an opening with one leaf is widened to its
// hinge, where no wall is seen between.
HalfOpen windows_of_leaves(const RaySamples& samples, const std::vector<StandingLeaf>& leaves, double alike,
                           std::vector<FoundRectangle>& openings);

}  // namespace ilot
