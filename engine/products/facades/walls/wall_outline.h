// SPDX-License-Identifier: Apache-2.0
// The wall's own outline: a rectangle, or what gables and steps leave of one.
#pragma once
#include <vector>

#include "engine/model/facade.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

struct WallOutlineParams {
  double least_length = 1;  // metres that a sloping edge, or a level one below the wall's top, goes on
  double least_step = 0.3;  // metres from such a level edge up to the wall's top
  double relief = 1.5;      // metres before the wall; where such things stand above an edge, they hide the wall there
};

// Counter-clockwise from the lower left end, the second corner is the lower right one.
struct WallOutline {
  std::vector<Place2> ring;
  std::vector<FacadeEdge> edges;  // as many; none where it is the wall's rectangle
};

// The foot and both ends are those of the rectangle; its top is what the rings of the wall's planes reach (top_lines),
// where nothing before the wall or along it is above: a line is fitted to them by total least squares [Marchand 2018,
// II.5.1], moved out by the root of 3 times their scatter, by half a step at most (points end anywhere within a step of
// the edge), corners are where lines meet [Marchand 2018, II.5.2]. Level edges below the top are drawn towards an end
// of the wall (a step), not between higher ones (a gap: something hides the wall). What no line tells goes up to the
// top. Stretches of sloping edges that the rings leave by more than a shadow are `occluded`. O(corners of the rings +
// points).
WallOutline wall_outline(const RaySamples& samples, const WallOutlineParams& params = {});

}  // namespace ilot
