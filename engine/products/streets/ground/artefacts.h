// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/streets/ground/ground.h"

namespace ilot {

struct ArtefactParams {
  double least_height = 0.1;  // metres above the ground around
  double ring_reach = 5;      // metres in which the ring around the ground looks for the local ground height
  double highest_kerb = 0.3;  // metres; lower plateaus
  double least_plateau = 1;   // of so many square metres are pavement
};

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

}  // namespace ilot
