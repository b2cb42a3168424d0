// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/link_regions.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// link_regions of an image that is too large to hold, tile by tile: the links of the whole, whatever the tiles. A tile
// sees half of max_length beyond its border, which is as far as the two halves of a link go from where they meet; of
// the links that it finds it keeps a least spanning tree, and that of all tiles' trees is that of the whole. `zones`:
// labels of flat_zones_tiled(step, eight) as heights, 0 for none. `read` is called once for each tile, `heights` and
// `zones` once before that, `write` last. Tiles in parallel. Memory: for each thread some 25 bytes a pixel of a tile
// with its halo; for all tiles their links.
void link_regions_tiled(const TileGrid& grid, const LinkRegionsParams& params, const ReadTile& read,
                        const ReadAround& heights, const ReadAround& zones, const WriteTile& write);

}  // namespace ilot
