// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "kernels/rasters/tiles.h"

namespace ilot {

// The caller's way to keep the labels of a tile; called from several threads at once, for different tiles.
using WriteLabels = std::function<void(std::size_t tile, const PixelLabels& labels)>;

struct ZoneSizes {
  std::vector<std::uint64_t> pixels;  // of each zone; [0] = those without one
};

// flat_zones of an image that is too large to hold, tile by tile: the labels of the whole, whatever the tiles, numbered
// by first pixel in the whole. Zones of tiles are joined across their borders by union-find. `read` is called once or
// twice for each tile, `write` once, the first of all before it; tiles in parallel. Memory: for each thread some 16
// bytes a pixel of a tile; for all tiles 16 bytes a zone of a tile, 8 a pixel of their borders, and a tenth of a byte a
// pixel at most. Fewer than 2^32 zones of tiles.
ZoneSizes flat_zones_tiled(const TileGrid& grid, Height lambda, Adjacency adjacency, const ReadTile& read,
                           const WriteLabels& write);

}  // namespace ilot
