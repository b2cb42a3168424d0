// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/morphology/border_zones.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// Missing pixels filled basin by basin [Hernandez and Marcotegui 2008, 3.2]: every region of pixels without a height,
// joined across sides and corners, gets the lowest height around it, each region for itself, so that far ones do not
// decide. Regions that touch the border of the image are open and stay without. The image is too large to hold: tile by
// tile, with the values of the whole whatever the tiles (tests/oracles/whole_fill.h has the whole). A tile fills the
// regions that lie within it and tells of those that reach its border; joined, these are filled too. In order: fill of
// all tiles, join, finish of all. Different tiles from several threads at once. Memory: for each thread some 12 bytes a
// pixel of a tile; for all tiles 8 bytes a pixel of their borders.
class TiledMissing {
 public:
  explicit TiledMissing(const TileGrid& grid);

  // `around`: the tile and a pixel on all four sides, kNoHeight outside of the image. Gives the tile. O(n).
  Image fill(std::size_t tile, const Image& around);
  void join();
  // From what `fill` gave to the values of the whole. Whether a value changed.
  bool finish(std::size_t tile, Image& image) const;

 private:
  void open_at_ends(std::size_t tile, const ZoneRuns& missing, std::vector<Height>& levels) const;

  TileGrid grid_;
  BorderPixels pixels_;
  BorderZones borders_;
  std::vector<std::vector<Height>> recorded_;  // by tile: of each region on its border the lowest height around it
  std::vector<Height> levels_;                 // of those joined
};

}  // namespace ilot
