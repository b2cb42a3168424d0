// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/tiles.h"

namespace ilot {

// reconstruct_by_erosion of an image that is too large to hold, tile by tile: the values of the whole, whatever the
// tiles. Each tile tells the spill heights between the pixels of its border, a graph of the borders of all tiles gives
// what reaches each of them from anywhere, and each tile is settled once more with that (after parallel priority flood,
// Barnes 2016). `read_marker` and `read_mask` are called twice for each tile, `write` once, all of them before it.
// Tiles in parallel. Memory: for each thread some 30 bytes a pixel of a tile; for all tiles some 60 bytes a pixel of
// their borders, a quarter of a byte for each pixel of the whole at a side of 1024.
void reconstruct_by_erosion_tiled(const TileGrid& grid, Adjacency adjacency, const ReadTile& read_marker,
                                  const ReadTile& read_mask, const WriteTile& write);

// Its dual, as reconstruct_by_dilation.
void reconstruct_by_dilation_tiled(const TileGrid& grid, Adjacency adjacency, const ReadTile& read_marker,
                                   const ReadTile& read_mask, const WriteTile& write);

// fill_holes in the same way.
void fill_holes_tiled(const TileGrid& grid, Adjacency adjacency, const ReadTile& read, const WriteTile& write);

}  // namespace ilot
