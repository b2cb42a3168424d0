// SPDX-License-Identifier: Apache-2.0
// Crowns of trees, told apart in images of the highest vegetation.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// A trunk below the crowns: the cell over it.
struct TrunkCell {
  std::uint32_t x = 0, y = 0;
  double radius = 0.1;  // metres
};

struct CrownParams {
  Height least_height = 0;  // units above the ground; lower cells are part of no crown
  // Two crowns are one where the pass between them is higher than these shares of the lower top: without a trunk below
  // both, and with a trunk below one of them.
  double pass_without_trunk = 0.9;
  double pass_with_trunk = 0.75;
  // A crown without a trunk that is narrower than this share of its height is a part of a neighbour where the pass to
  // it is higher than that share of the lower top.
  double slender = 0.15;  // radius of the circle with the crown's area over the height
  double pass_of_slender = 0.5;
  double cell = 400;  // side of a cell in the units of heights
  // Below one crown what is thinner than the trunk by this factor is a post.
  double post = 2;
};

struct CrownRegion {
  int trunk = -1;       // index of its trunk; -1 = none was seen
  std::size_t top = 0;  // cell of its highest point
};

struct CrownRegions {
  std::vector<std::uint32_t> of;  // per cell: region + 1, 0 = none
  std::vector<CrownRegion> regions;
};

// Tells crowns apart. `above` is the height of the highest vegetation of each cell above the ground, kNoHeight without
// any. Every cell climbs to the treetop that its steepest neighbours lead to. A treetop's region with several trunks is
// split by the nearest trunk. Then neighbours are joined, the pair with the highest pass (as a share of the lower of
// both tops) first, but never two with a trunk each, unless one of them is so thin that it is a post below the other's
// crown. Ties by number. O(cells log cells).
CrownRegions find_crowns(const Image& above, std::span<const TrunkCell> trunks, const CrownParams& params);

}  // namespace ilot
