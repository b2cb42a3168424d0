// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/products/streets/ground/ground.h"
#include "engine/tiles/street_layers.h"

namespace ilot {

// Flat zones that may be ground, in square metres: those that were taken, and others that nothing joins to them, each
// at least a tenth of the largest in their group of tiles: a street beyond a bridge, or a roof.
struct GroundZones {
  double taken = 0;
  std::vector<double> left_out;  // the largest first
};

// find_ground of a street that is too large to hold: from the layer "range" to "filled" and "mask", pixel by pixel what
// find_ground makes of the whole. Where tiles are absent, each group of tiles that touch has a ground of its own.
GroundZones find_ground_tiled(const StreetLayers& layers, const RasterScale& scale, const GroundParams& params = {});

}  // namespace ilot
