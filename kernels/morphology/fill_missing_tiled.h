// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/morphology/border_zones.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// Fills missing pixels basin by basin [Hernandez and Marcotegui 2008, 3.2]. Every region of pixels without a height,
// joined across sides and corners, gets the lowest height around it. Each region is filled on its own, so that far
// regions do not decide. Regions that touch the border of the image are open and stay without a height. The image is
// too large for memory and is processed tile by tile. The values are those of the whole image, whatever the tiles are
// (tests/oracles/whole_fill.h fills the whole image). A tile fills the regions inside it and records those that reach
// its border. These are joined and then filled too. Call in this order: fill of all tiles, join, finish of all tiles.
// Different tiles may be processed from several threads at once. Memory: about 12 bytes per pixel of a tile for each
// thread, and 8 bytes per border pixel of all tiles.
class TiledMissing {
 public:
  explicit TiledMissing(const TileGrid& grid);

  // `around` is the tile with one more pixel on all four sides, kNoHeight outside of the image. Returns the tile. O(n).
  Image fill(std::size_t tile, const Image& around);
  void join();
  // Changes the result of `fill` to the values of the whole image. Returns whether a value changed.
  bool finish(std::size_t tile, Image& image) const;

 private:
  void open_at_ends(std::size_t tile, const ZoneRuns& missing, std::vector<Height>& levels) const;

  TileGrid grid_;
  BorderPixels pixels_;
  BorderZones borders_;
  std::vector<std::vector<Height>> recorded_;  // by tile: the lowest height around each region on its border
  std::vector<Height> levels_;                 // of the joined regions
};

}  // namespace ilot
