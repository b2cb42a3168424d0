// SPDX-License-Identifier: Apache-2.0
// Gives access to a whole image in the way that tiled kernels need.
#pragma once
#include "kernels/rasters/tiles.h"

namespace ilot::test {

// Returns the grid with only the flagged tiles. `present` has one flag for each tile, row by row.
inline TileGrid with_tiles(TileGrid grid, const std::vector<std::uint8_t>& present) {
  for (std::uint32_t t = 0; t < present.size(); ++t)
    if (present[t] != 0) grid.tiles.push_back({t / grid.columns(), t % grid.columns()});
  return grid;
}

inline ReadTile tiles_of(const Image& image, const TileGrid& grid) {
  return [&image, grid](std::size_t tile) {
    const TileFrame frame = tile_frame(grid, tile);
    Image out = filled_image(frame.width, frame.height, 0);
    for (std::uint32_t y = 0; y < frame.height; ++y)
      for (std::uint32_t x = 0; x < frame.width; ++x)
        out.values[std::size_t{y} * frame.width + x] =
            image.values[std::size_t{frame.y + y} * image.width + frame.x + x];
    return out;
  };
}

inline WriteTile into(Image& image, const TileGrid& grid) {
  return [&image, grid](std::size_t tile, const Image& part) {
    const TileFrame frame = tile_frame(grid, tile);
    for (std::uint32_t y = 0; y < frame.height; ++y)
      for (std::uint32_t x = 0; x < frame.width; ++x)
        image.values[std::size_t{frame.y + y} * image.width + frame.x + x] =
            part.values[std::size_t{y} * frame.width + x];
  };
}

}  // namespace ilot::test
