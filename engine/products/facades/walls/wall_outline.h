// SPDX-License-Identifier: Apache-2.0
// The outline of the wall: a rectangle, or the part of one that gables and steps leave.
#pragma once
#include <vector>

#include "engine/model/facade.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

struct WallOutlineParams {
  double least_length = 1;  // metres; least length of a sloping edge, or of a level edge below the top of the wall
  double least_step = 0.3;  // metres from such a level edge up to the top of the wall
  double relief = 1.5;      // metres before the wall; points above an edge within this hide the wall there
};

// The ring is counter-clockwise from the lower left end; the second corner is the lower right one.
struct WallOutline {
  std::vector<Place2> ring;
  std::vector<FacadeEdge> edges;  // one per corner; none where the outline is the rectangle of the wall
};

// The foot and both ends are those of the rectangle. The top is given by the rings of the planes of the wall
// (top_lines), where nothing before the wall or along it is higher. A line is fitted to the rings by total least
// squares [Marchand 2018, II.5.1]. It is moved outwards by the root of 3 times the scatter of the rings, but at most by
// half a step: points end anywhere within one step of the edge. Corners are where lines meet [Marchand 2018, II.5.2]. A
// level edge below the top is drawn if it extends to an end of the wall (a step). It is not drawn between higher edges
// (a gap: something hides the wall). Where no line is known, the outline goes up to the top. A part of a sloping edge
// is `occluded` where the rings are away from it by more than a shadow. O(corners of the rings + points).
WallOutline wall_outline(const RaySamples& samples, const WallOutlineParams& params = {});

}  // namespace ilot
