// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/products/streets/ground/ground.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

// Flat zones that may be ground, in square metres: those that were taken, and others that nothing joins to them, each
// at least a tenth of the largest in their group of tiles: a street beyond a bridge, or a roof.
struct GroundZones {
  double taken = 0;
  std::vector<double> left_out;  // the largest first
};

// The ground of a street [Hernandez and Marcotegui 2008, 3.2]: gaps between scan lines closed (ours: the document's
// clouds have a point in every pixel), pixels without a height filled basin by basin; regions that shadows still cut
// apart linked along their shortest connections, and the holes that this closes filled; of the zones flat within `flat`
// the first of those with the greatest ground_rank is the ground (ours: the document takes the largest), and what it
// encloses, as lampposts, belongs to it; what stayed without a height never does. Nothing with a height: an empty mask.
// From the layer "range" to "filled" and "mask", pixel by pixel the same whatever the tiles. Where tiles are absent,
// each group of tiles that touch has a ground of its own.
GroundZones find_ground_tiled(const TileLayers& layers, const RasterScale& scale, const GroundParams& params = {});

}  // namespace ilot
