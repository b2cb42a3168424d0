// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/cells.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

struct StreetMaskParams {
  double building_height = 1.5;  // metres above the terrain; in a cell of a building, pixels that are higher belong to
                                 // it, and where the cell is lower than a third more, pixels above three quarters of it
  double fixed_reach = 0.15;     // metres; what stands so near to a building is fixed to it
  double on_ground = 0.1;        // metres above the terrain; what is lower is ground and never fixed to a building
};

// Decides where ground and objects on it are. Reads the layers "range" and "filled" of pixels, "terrain",
// "structure" and "top" of cells, and drops the last. Writes "mask": 1 for all pixels with a height that do not belong
// to a building, whatever they are connected to, and "foot", the height of the terrain.
void find_street_mask(const TileLayers& layers, const Cells& cells, const StreetMaskParams& params = {});

// Puts the ground on the terrain: where "bare" is farther than `farthest` metres from it, as on terraces that the
// filling took for objects, it becomes the terrain. Then rewrites "height", what stands at least least_height metres
// above it. Reads the layers "filled" and "mask".
void put_on_terrain(const TileLayers& layers, const Cells& cells, double farthest, double least_height);

// The terrain of the pixels of a tile and of `halo` more on all sides, between the middles of cells; kNoHeight where it
// is not known.
Image terrain_of_pixels(const Cells& cells, std::size_t tile, std::uint32_t halo);

}  // namespace ilot
