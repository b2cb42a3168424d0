// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/ground.h"
#include "engine/tiles/raster_scale.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

// Fills the range image of a street [Hernandez and Marcotegui 2008, 3.2] in these steps:
//  - Gaps between scan lines are closed (our addition: the clouds of the paper have a point in every pixel).
//  - Pixels without a height are filled basin by basin.
//  - Regions that shadows still separate are linked along their shortest connections, and the holes that this closes
//    are filled.
// Reads the layer "range" and writes "filled". Each pixel is the same for any tiles.
void fill_ground_tiled(const TileLayers& layers, const RasterScale& scale, const GroundParams& params = {});

}  // namespace ilot
