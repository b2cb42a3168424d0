// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "kernels/rasters/tiles.h"

namespace ilot {

// Writes the labels of a tile for the caller. It is called from several threads at once, for different tiles.
using WriteLabels = std::function<void(std::size_t tile, const PixelLabels& labels)>;

struct ZoneSizes {
  std::vector<std::uint64_t> pixels;  // of each zone; [0] = those without one
};

// Computes flat_zones of an image that is too large for memory, tile by tile. The labels are those of the whole image,
// whatever the tiles are, and are numbered by their first pixel in the whole image. Zones of tiles are joined across
// their borders by union-find. `read` is called once or twice for each tile and `write` once. All first calls of `read`
// come before any `write`. Tiles are processed in parallel. Memory: about 16 bytes per pixel of a tile for each thread;
// for all tiles 16 bytes per zone of a tile, 8 bytes per border pixel, and at most a tenth of a byte per pixel. There
// must be fewer than 2^32 zones of tiles.
ZoneSizes flat_zones_tiled(const TileGrid& grid, Height lambda, Adjacency adjacency, const ReadTile& read,
                           const WriteLabels& write);

}  // namespace ilot
