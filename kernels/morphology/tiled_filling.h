// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/morphology/border_pixels.h"
#include "kernels/morphology/perimeter.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// The caller's way to keep the spills of each tile; empty: they are kept in memory.
struct SpillStore {
  std::function<void(std::size_t tile, std::vector<SpillEdge> spills)> write = {};
  std::function<std::vector<SpillEdge>(std::size_t tile)> read = {};
};

// Hole filling [Hernandez and Marcotegui 2008, 3.2]: raises every minimum that is not joined to the border of the image
// to the height at which water in it would run off over the border: the least, over all paths from a pixel to the
// border, of the highest pixel on the path. Pixels without a height are the lowest of all: those joined to the border
// stay without. Unique. Then water can be let out of what was filled. The image is too large to hold: tile by tile,
// with the values of the whole whatever the tiles (tests/oracles/whole_fill.h has the whole). Each tile is filled as if
// its own border let the water out, and tells the spill heights between the pixels of its border; a graph of all
// borders gives what each of them is really filled to, and only what is below that is raised once more (after parallel
// priority flood, Barnes 2016). In order: fill of all tiles, join, raise of all; then, if anything is drained,
// record_drained of some, join_drained, lower of all. Different tiles from several threads at once. Memory: for each
// thread some 30 bytes a pixel of a tile; for all tiles 9 bytes a pixel of their borders, and 12 for their spills where
// the caller does not keep them.
class TiledFilling {
 public:
  TiledFilling(const TileGrid& grid, Adjacency adjacency, SpillStore spills = {});

  // The tile filled with every pixel of its border an outlet. O(n log(range)).
  Image fill(std::size_t tile, const Image& image);
  void join();
  // From what `fill` gave to the values of the whole. Looks at the border and at what is raised.
  // Whether a value changed.
  bool raise(std::size_t tile, Image& filled) const;

  // `drained`: reconstruct_by_erosion of the tile alone, from a marker that is its raised filling but for pixels that
  // are lower.
  void record_drained(std::size_t tile, const Image& drained);
  void join_drained();
  // From what was told, or the raised filling, to the reconstruction of the whole from that marker. `image`: as given
  // to `fill`. Looks at the border and at what is lowered.
  void lower(std::size_t tile, const Image& image, Image& drained) const;

 private:
  struct Pending;
  void propagate();
  void propagate_tile(std::size_t tile, Pending& pending);

  Adjacency adjacency_;
  BorderPixels pixels_;
  SpillStore store_;
  std::vector<std::vector<SpillEdge>> spills_;  // by tile, where the caller does not keep them
  std::vector<Height> mask_, reached_;          // of all borders: the image's height, and what it is filled to
  std::vector<std::uint8_t> open_;              // of all borders: 1 where others may still be reached from
};

}  // namespace ilot
