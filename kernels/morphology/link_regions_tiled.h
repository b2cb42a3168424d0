// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/morphology/region_links.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// The links of link_regions for an image that is too large to hold, tile by tile: those of the whole, whatever the
// tiles. Of each tile the pixels to be drawn, the first height of a pixel counts. A tile sees half of max_length beyond
// its border, which is as far as the two halves of a link go from where they meet; of the links that it finds it keeps
// a least spanning tree, and that of all tiles' trees is that of the whole. `zones`: numbers in the whole of its flat
// zones (step, eight) as heights, 0 or kNoHeight for none; an empty image where there are not two of them. Tiles in
// parallel. Memory: for each thread some 30 bytes a pixel of a tile with its halo; for all tiles their links.
std::vector<std::vector<LinkPixel>> links_tiled(const TileGrid& grid, const LinkRegionsParams& params,
                                                const ReadAround& heights, const ReadAround& zones);

}  // namespace ilot
