// SPDX-License-Identifier: Apache-2.0
// Inside of find_ground_tiled: the ground and what it encloses.
#pragma once
#include "engine/products/streets/ground/tile_zones.h"

namespace ilot {

// From the zones and "filled" to "mask": the zone chosen for each group of tiles and all that no path from side to side
// leads from to the end of the image without crossing it; but for pixels without a height.
void find_enclosed_ground(const TileLayers& layers, const char* zones_layer, const TileZones& zones,
                          const GroundOfGroups& chosen, const TileGroups& groups);

}  // namespace ilot
