// SPDX-License-Identifier: Apache-2.0
// The ground of a street and what stands on it, in images that are in memory as a whole: what the tiled steps must
// agree with.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/streets/ground/artefacts.h"
#include "engine/products/streets/ground/ground.h"

namespace ilot::test {

struct Ground {
  Image filled;                    // the range image without its gaps, as far as they are closed
  std::vector<std::uint8_t> mask;  // 1: ground, and all that stands on it
};

// The ground of a street [Hernandez and Marcotegui 2008, 3.2]: gaps between scan lines closed (ours: the document's
// clouds have a point in every pixel), pixels without a height filled basin by basin; regions that shadows still cut
// apart linked along their shortest connections, and the holes that this closes filled; of the zones flat within `flat`
// the first of those with the greatest ground_rank is the ground (ours: the document takes the largest), and what it
// encloses, as lampposts, belongs to it; what stayed without a height never does. `range`: highest z per pixel. Nothing
// with a height: an empty mask. O(n) but for the links.
Ground find_ground(const Image& range, const RasterScale& scale, const GroundParams& params = {});

struct Artefacts {
  Image height;                      // above the ground around; kNoHeight where nothing stands
  std::vector<std::uint8_t> ground;  // 1: ground with nothing on it
};

// What stands on the ground [Hernandez and Marcotegui 2008, 4]: top-hat of hole filling. The ground image upside down
// has a hole where something stands; around the mask runs a ring at the local ground height, the lowest within
// ring_reach, so that what stands at its edge is a hole too, and a sloping street none. Holes at least least_height
// deep are artefacts. Ours: where the ring and the road close off a pavement, all of it is a shallow hole. Plateaus no
// higher than highest_kerb and no smaller than least_plateau are drained, and the filling is done again, so that what
// stands on them rises from them. At the border of the image the ground goes on. Costs two hole fillings.
Artefacts find_artefacts(const Ground& ground, const RasterScale& scale, const ArtefactParams& params = {});

}  // namespace ilot::test
