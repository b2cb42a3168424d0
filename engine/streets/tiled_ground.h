// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/streets/ground.h"
#include "engine/streets/street_layers.h"

namespace ilot {

// find_ground of a street that is too large to hold: from the layer "range" to "filled" and "mask", pixel by pixel what
// find_ground makes of the whole. Where tiles are absent, each group of tiles that touch has a ground of its own.
void find_ground_tiled(const StreetLayers& layers, const RasterScale& scale, const GroundParams& params = {});

}  // namespace ilot
