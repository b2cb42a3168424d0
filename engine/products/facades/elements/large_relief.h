// SPDX-License-Identifier: Apache-2.0
// Finds what stands out of a wall or goes into it by decimetres: bays, oriels, niches, cut corners, arcades.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

struct LargeReliefParams {
  double least_size = 0.3;   // metres, along the wall
  double least_depth = 0.1;  // metres, out of the wall or into it
  double most_depth = 2.5;   // metres; what lies farther away does not belong to the wall
};

// The wall is seen from outside as an image of depths, which shows the foremost points. A region in front of the wall
// is a protrusion if side faces connect it with the wall; a car has none. A region behind the wall is a recess if the
// wall bounds it above or on both sides; what lies beyond the end of the wall is no recess. Each is given as two
// rectangles: the one where it meets the wall and the one where it ends [Lorraine thesis, 4.2.1]. Its sides come from
// the points on its side faces where there are some. The wall is taken to cover every opening, so that regions as large
// as windows are found too. The order is by place, from bottom to top. O(points).
std::vector<FoundRectangle> find_large_relief(const RaySamples& samples, const LargeReliefParams& params = {});

}  // namespace ilot
