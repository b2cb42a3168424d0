// SPDX-License-Identifier: Apache-2.0
// The ground of a street and its artefacts, in images that are in memory as a whole. The tiled steps must give the same
// result.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/streets/ground/artefacts.h"
#include "engine/products/streets/ground/ground.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/image.h"

namespace ilot::test {

struct Ground {
  Image filled;                    // the range image after its gaps are closed as far as possible
  std::vector<std::uint8_t> mask;  // 1: ground, and everything on it
};

// Finds the ground of a street [Hernandez and Marcotegui 2008, 3.2]. Gaps between scan lines are closed (this step is
// ours: the clouds of the document have a point in every pixel). Pixels without a height are filled basin by basin.
// Regions that laser shadows still separate are linked along their shortest connections, and the holes that this
// encloses are filled. Among the zones that are flat within `flat`, the first of those with the greatest ground_rank is
// the ground (this rule is ours: the document takes the largest). What the ground encloses, such as lampposts, belongs
// to it. Pixels that still have no height never belong to it. `range` is the highest z per pixel. If no pixel has a
// height, the mask is empty. O(n) without the links.
Ground find_ground(const Image& range, const RasterScale& scale, const GroundParams& params = {});

struct Artefacts {
  Image height;                      // height above the ground around it; kNoHeight where there is no artefact
  std::vector<std::uint8_t> ground;  // 1: ground without an artefact
};

// Finds the artefacts on the ground [Hernandez and Marcotegui 2008, 4] by the top hat of the hole filling. The ground
// image is turned upside down, so an artefact becomes a hole. A ring around the mask has the local ground height, which
// is the lowest within ring_reach. So an artefact at the edge of the mask is a hole too, and a sloping street is not.
// Holes at least least_height deep are artefacts. One rule is ours: where the ring and the road enclose a pavement, the
// whole pavement is a shallow hole. Plateaus that are no higher than highest_kerb and no smaller than least_plateau are
// drained, and the filling is repeated, so that artefacts on them rise from them. At the border of the image the ground
// continues. The cost is that of two hole fillings.
Artefacts find_artefacts(const Ground& ground, const RasterScale& scale, const ArtefactParams& params = {});

}  // namespace ilot::test
