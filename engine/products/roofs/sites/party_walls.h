// SPDX-License-Identifier: Apache-2.0
// Where one outline holds several buildings wall to wall.
#pragma once
#include <span>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

struct PartyWallParams {
  double least_step = 0.5;    // metres between the roofs to either side
  double least_share = 0.75;  // of the wall's length along which they are so far apart
  double least_wall = 4;      // metres
  double least_area = 30;     // m2 of a building; smaller parts are annexes of their neighbour
  double least_depth = 3.5;   // metres: area over the length of the wall
};

// The outline cut along straight lines from border to border, in a direction of its own or across it, where roofs are
// apart in height nearly all the way: houses in a row seldom have the same roof. The clearest wall first (the most
// metres with a step less those without), then those of its parts. Between the points of both sides a wall lies as
// other steps do (step_offset.h). Parts share the vertices of their walls. Points in metres from the outline's anchor;
// `step` metres between them. The largest part first. A function of the outline and the set of points. O(points x
// walls).
std::vector<SitePolygon> split_at_party_walls(const SitePolygon& outline, std::span<const Vec3> points, double step,
                                              const PartyWallParams& params = {});

}  // namespace ilot
