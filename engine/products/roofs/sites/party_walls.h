// SPDX-License-Identifier: Apache-2.0
// Splits an outline that contains several adjoining buildings.
#pragma once
#include <span>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

struct PartyWallParams {
  double least_step = 0.5;    // metres of height between the roofs on the two sides
  double least_share = 0.75;  // share of the wall's length along which the step is this high
  double least_wall = 4;      // metres
  double least_area = 30;     // m2 of a building; smaller parts are annexes of a neighbour
  double least_depth = 3.5;   // metres; area divided by the length of the wall
};

// Cuts the outline along straight lines from border to border where the roofs differ in height nearly all the way,
// because houses in a row seldom have the same roof. The lines run in a direction of the outline or across it. The
// clearest wall is cut first (the most metres with a step minus those without), then the walls of its parts. A wall
// lies between the points of its two sides as other steps do (step_offset.h). Parts share the vertices of their walls.
// The points are in metres from the outline's anchor, `step` metres apart. The largest part comes first. The result is
// a function of the outline and the set of points. O(points x walls).
std::vector<SitePolygon> split_at_party_walls(const SitePolygon& outline, std::span<const Vec3> points, double step,
                                              const PartyWallParams& params = {});

}  // namespace ilot
