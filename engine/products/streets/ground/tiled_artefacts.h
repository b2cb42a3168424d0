// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/artefacts.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

// What stands on the ground [Hernandez and Marcotegui 2008, 4]: top-hat of hole filling. The ground image upside down
// has a hole where something stands; around the mask runs a ring at the local ground height, the lowest within
// ring_reach, so that what stands at its edge is a hole too, and a sloping street none. Holes at least least_height
// deep are artefacts. Ours: where the ring and the road close off a pavement, all of it is a shallow hole. Plateaus no
// higher than highest_kerb and no smaller than least_plateau are drained, and the filling is done again, so that what
// stands on them rises from them. At the border of the image the ground goes on. From the layers "filled" and "mask" to
// "height" (above the ground around; kNoHeight where nothing stands) and "bare": the ground below it, kNoHeight outside
// of the mask; pixel by pixel the same whatever the tiles.
void find_artefacts_tiled(const TileLayers& layers, const RasterScale& scale, const ArtefactParams& params = {});

}  // namespace ilot
