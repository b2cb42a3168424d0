// SPDX-License-Identifier: Apache-2.0
// Decides for each wall of a run which side is the street when no station is known.
#pragma once
#include <span>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/facades/facade_gathering.h"

namespace ilot {

// Gives the log odds that the street is on the side of `out` of each wall: from the points around the wall, from the
// larger wall of another storey, and where these say little, also from the walls that continue it. The points of all
// walls are read once, each wall on one thread. The store must have the column "plane".
std::vector<double> wall_side_odds(const FacadeWork& work, std::span<const WallGroup> walls, double gap,
                                   const PassContext& context);

// Gives the odds of wall i for its own `out`, from the odds of each wall by itself: those of the largest wall of a
// storey above or below it, where that wall is larger than it and sure of its side; else its own. What stands out above
// a wall looks like a house behind it. O(walls).
double storey_odds(std::span<const WallGroup> walls, std::span<const double> own, std::size_t i,
                   double metres_per_unit);

// The same by segment: log odds for the side of the plane's normal; 0 for segments that are no part of a wall. A plane
// that was cut into the walls of several houses has the sum of theirs, since they face one street.
std::vector<double> segment_side_odds(std::span<const WallGroup> walls, std::span<const double> odds,
                                      std::span<const Segment> segments);

// Turns a wall so that it looks the other way; its place stays.
void turn_wall(WallGroup& wall, double metres_per_unit);

}  // namespace ilot
