// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/morphology/border_pixels.h"
#include "kernels/morphology/perimeter.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// Stores the spills of each tile for the caller. When it is empty, the spills stay in memory.
struct SpillStore {
  std::function<void(std::size_t tile, std::vector<SpillEdge> spills)> write = {};
  std::function<std::vector<SpillEdge>(std::size_t tile)> read = {};
};

// Hole filling [Hernandez and Marcotegui 2008, 3.2]. Every minimum that is not joined to the border of the image is
// raised to the height at which water in it would run off over the border. This height is the least, over all paths
// from a pixel to the border, of the highest pixel on the path. Pixels without a height are the lowest of all, and
// those joined to the border stay without. The result is unique. After the filling, water can be let out of what was
// filled.
// The image is too large for memory and is processed tile by tile. The values are those of the whole image, whatever
// the tiles are (tests/oracles/whole_fill.h fills the whole image). Each tile is first filled as if its own border let
// the water out, and records the spill heights between its border pixels. A graph of all borders gives the true filled
// height of each border pixel. Only the pixels below that height are raised once more (after parallel priority flood,
// Barnes 2016).
// Call in this order: fill of all tiles, join, raise of all tiles. If something is drained, call record_drained of some
// tiles, join_drained, and lower of all tiles. Different tiles may be processed from several threads at once. Memory:
// about 30 bytes per pixel of a tile for each thread; for all tiles 9 bytes per border pixel, and 12 bytes per border
// pixel for the spills where the caller does not store them.
class TiledFilling {
 public:
  TiledFilling(const TileGrid& grid, Adjacency adjacency, SpillStore spills = {});

  // Returns the filled tile, where every pixel of its border is an outlet. O(n log(range)).
  Image fill(std::size_t tile, const Image& image);
  void join();
  // Changes the result of `fill` to the values of the whole image. It reads the border and the pixels that are raised.
  // Returns whether a value changed.
  bool raise(std::size_t tile, Image& filled) const;

  // `drained` is reconstruct_by_erosion of the tile alone. Its marker is the raised filling of the tile with some lower
  // pixels.
  void record_drained(std::size_t tile, const Image& drained);
  void join_drained();
  // Changes the recorded tile, or the raised filling, to the reconstruction of the whole image from that marker.
  // `image` is the image that was given to `fill`. The function reads the border and the pixels that are lowered.
  void lower(std::size_t tile, const Image& image, Image& drained) const;

 private:
  struct Pending;
  void propagate();
  void propagate_tile(std::size_t tile, Pending& pending);

  Adjacency adjacency_;
  BorderPixels pixels_;
  SpillStore store_;
  std::vector<std::vector<SpillEdge>> spills_;  // by tile, where the caller does not store them
  std::vector<Height> mask_, reached_;  // of all borders: the height of the image, and the height to which it is filled
  std::vector<std::uint8_t> open_;      // of all borders: 1 where others may still be reached from this pixel
};

}  // namespace ilot
