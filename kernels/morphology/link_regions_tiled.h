// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/morphology/region_links.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// Regions that shadows cut apart, linked along their shortest connections [Hernandez and Marcotegui 2008, 3.2]: regions
// are lambda-flat zones (corners join) of the pixels with a height; links run from side to side over pixels without
// one, the shortest first, until all regions that can be are one (a least spanning tree, Kruskal 1956). Links' pixels
// get heights between those of their two ends, in even steps. A link is sought where the pixels nearest to the one
// region meet those nearest to the other (of equally near ends the first, row by row); of equally long links the one
// with the first end goes first. All other pixels stay as they are. A chain of links that closes a gap around makes a
// hole of it (fill_missing_tiled.h). The image is too large to hold: tile by tile, with the links of the whole whatever
// the tiles (tests/oracles/whole_links.h has the whole). Of each tile the pixels to be drawn, the first height of a
// pixel counts. A tile sees half of max_length beyond its border, which is as far as the two halves of a link go from
// where they meet; of the links that it finds it keeps a least spanning tree, and that of all tiles' trees is that of
// the whole. `zones`: numbers in the whole of its flat zones (step, eight) as heights, 0 or kNoHeight for none; an
// empty image where there are not two of them. Tiles in parallel. Memory: for each thread some 30 bytes a pixel of a
// tile with its halo; for all tiles their links.
std::vector<std::vector<LinkPixel>> links_tiled(const TileGrid& grid, const LinkRegionsParams& params,
                                                const ReadAround& heights, const ReadAround& zones);

}  // namespace ilot
