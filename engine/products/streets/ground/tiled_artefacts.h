// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/artefacts.h"
#include "engine/tiles/raster_scale.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

// Finds what stands on the ground by the top hat of the hole filling [Hernandez and Marcotegui 2008, 4]. In the ground
// image upside down, an object is a hole. A ring around the mask gets the local ground height, the layer "foot" (the
// paper takes the lowest height near it). So an object at the edge of the mask is a hole too, and a sloping street is
// none. Holes that are at least least_height deep are artefacts. Our addition: where the ring and the road enclose a
// pavement, the whole pavement is a shallow hole. Plateaus that are at most highest_kerb high and at least
// least_plateau large are drained, and the filling is repeated, so that objects on a plateau rise from it. At the
// border of the image the ground is taken to continue. Reads the layers "filled", "mask" and "foot" and drops the last.
// Writes "height" (above the ground around; kNoHeight where nothing stands) and "bare" (the ground below; kNoHeight
// outside of the mask). Each pixel is the same for any tiles.
void find_artefacts_tiled(const TileLayers& layers, const RasterScale& scale, const ArtefactParams& params = {});

}  // namespace ilot
