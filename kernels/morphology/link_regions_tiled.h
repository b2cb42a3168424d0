// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/morphology/region_links.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// Links regions that laser shadows cut apart, along their shortest connections [Hernandez and Marcotegui 2008, 3.2].
// Regions are lambda-flat zones (corners join) of the pixels with a height. Links run from side to side over pixels
// without a height. The shortest links come first, until no more regions can be joined (a minimum spanning tree,
// Kruskal 1956). The pixels of a link get heights between those of its two ends, in even steps. All other pixels stay
// as they are. A chain of links that closes a gap on all sides makes it a hole (fill_missing_tiled.h).
// A link is sought where the pixels nearest to one region meet the pixels nearest to another. Of equally near ends the
// first one counts, row by row. Of equally long links the one with the first end comes first.
// The image is too large for memory and is processed tile by tile. The links are those of the whole image, whatever the
// tiles are (tests/oracles/whole_links.h links the whole image). The function returns for each tile the pixels to be
// drawn; where a pixel occurs twice, its first height counts. A tile sees half of max_length beyond its border, because
// the two halves of a link go no farther from the place where they meet. Of its links the tile keeps a minimum spanning
// tree. The minimum spanning tree of the trees of all tiles is that of the whole image.
// `zones` gives the numbers in the whole image of its flat zones (step, eight), stored as heights, with 0 or kNoHeight
// for none. It gives an empty image where there are fewer than two zones. Tiles are processed in parallel. Memory:
// about 30 bytes per pixel of a tile with its halo for each thread, and the links of all tiles.
std::vector<std::vector<LinkPixel>> links_tiled(const TileGrid& grid, const LinkRegionsParams& params,
                                                const ReadAround& heights, const ReadAround& zones);

}  // namespace ilot
