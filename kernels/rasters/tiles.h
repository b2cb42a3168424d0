// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>

#include "kernels/rasters/image.h"

namespace ilot {

// An image of any size cut into square tiles, those at the far ends smaller; numbered row by row. Only tiles are ever
// held, never the whole.
struct TileGrid {
  std::uint32_t width = 0, height = 0;  // of the whole, pixels; below 2^31
  std::uint32_t side = 1024;            // of a tile, pixels

  std::uint32_t columns() const { return (width + side - 1) / side; }
  std::uint32_t rows() const { return (height + side - 1) / side; }
  std::size_t count() const { return width == 0 || height == 0 ? 0 : std::size_t{columns()} * rows(); }
};

struct TileFrame {
  std::uint32_t x, y, width, height;  // of its first pixel in the whole; of the tile
};

inline TileFrame tile_frame(const TileGrid& grid, std::size_t tile) {
  assert(tile < grid.count());
  const auto x = static_cast<std::uint32_t>(tile % grid.columns()) * grid.side;
  const auto y = static_cast<std::uint32_t>(tile / grid.columns()) * grid.side;
  return {x, y, std::min(grid.side, grid.width - x), std::min(grid.side, grid.height - y)};
}

// The caller's access to the tiles, called from several threads at once, for different tiles.
using ReadTile = std::function<Image(std::size_t tile)>;
using WriteTile = std::function<void(std::size_t tile, const Image& image)>;

}  // namespace ilot
