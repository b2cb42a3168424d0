// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/deliverables/maps/map_cover.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

// The cover of a street: ground with points, crowns, and buildings, that is what stands higher outside of the ground.
// Reads the layers "mask", "range" and "structure" of the tiles that images show, once each time it paints. `tiles`
// must outlive it.
CoverSource street_cover(const StreetTiles& tiles);

}  // namespace ilot
