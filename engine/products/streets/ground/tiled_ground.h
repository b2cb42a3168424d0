// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/products/streets/ground/ground.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

// The flat zones that may be ground, with areas in square metres: those that are taken, and others that are not
// connected to them. Each of the others has at least a tenth of the area of the largest zone in its group of tiles, for
// example a street beyond a bridge, or a roof.
struct GroundZones {
  double taken = 0;
  std::vector<double> left_out;  // the largest first
};

// Finds the ground of a street [Hernandez and Marcotegui 2008, 3.2] in these steps:
//  - Gaps between scan lines are closed (our addition: the clouds of the paper have a point in every pixel).
//  - Pixels without a height are filled basin by basin.
//  - Regions that shadows still separate are linked along their shortest connections, and the holes that this closes
//    are filled.
//  - Of the flat zones (heights differ by at most `flat`), the first one with the greatest ground_rank is the ground
//    (our change: the paper takes the largest zone).
//  - What the ground encloses, such as lampposts, belongs to it. Pixels that are still without a height never belong to
//    it.
// If no pixel has a height, the mask is empty. Reads the layer "range" and writes "filled" and "mask". Each pixel is
// the same for any tiles. Where tiles are absent, each group of tiles that touch has a ground of its own.
GroundZones find_ground_tiled(const TileLayers& layers, const RasterScale& scale, const GroundParams& params = {});

}  // namespace ilot
