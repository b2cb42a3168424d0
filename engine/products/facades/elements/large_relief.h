// SPDX-License-Identifier: Apache-2.0
// What stands out of a wall or goes into it by decimetres: bays, oriels, niches, cut corners, arcades.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

struct LargeReliefParams {
  double least_size = 0.3;   // metres, along the wall
  double least_depth = 0.1;  // metres out of it or into it
  double most_depth = 2.5;   // metres; what lies farther is something else
};

// The wall is seen from outside as an image of depths: what is foremost. Regions before it that hang on it by side
// faces are protrusions (a car does not), regions behind it that the wall bounds above, or on both sides, are recesses
// (what lies beyond its end is none). Each as the rectangle where it meets the wall and the one where it ends [Lorraine
// thesis, 4.2.1], its sides from the points on its side faces where there are some. The wall goes over every opening:
// those of the size of windows are found too. By place, bottom up. O(points).
std::vector<FoundRectangle> find_large_relief(const RaySamples& samples, const LargeReliefParams& params = {});

}  // namespace ilot
