// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/tiles.h"

namespace ilot {

// fill_missing of an image that is too large to hold, tile by tile: the values of the whole, whatever the tiles.
// `around` is called three times for each tile (without a halo, then with one of a pixel, then without), `regions`
// keeps the numbers of the missing regions of each tile in between and gives them back. Tiles in parallel. Memory as
// flat_zones_tiled, and 4 bytes a region.
struct RegionTiles {
  WriteTile write;
  ReadTile read;
};
void fill_missing_tiled(const TileGrid& grid, const ReadAround& around, const RegionTiles& regions,
                        const WriteTile& write);

}  // namespace ilot
