// SPDX-License-Identifier: Apache-2.0
// Internal to find_ground_tiled: the ground and what it encloses.
#pragma once
#include "engine/products/streets/ground/tile_zones.h"

namespace ilot {

// Computes "mask" from the zones and "filled". The mask contains the zone that was chosen for each group of tiles, and
// everything from which no path (from pixel to pixel across a common side) leads to the border of the image without
// crossing that zone. Pixels without a height are not in the mask.
void find_enclosed_ground(const TileLayers& layers, const char* zones_layer, const TileZones& zones,
                          const GroundOfGroups& chosen, const TileGroups& groups);

}  // namespace ilot
