// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Calls body(i) once for each of bytes.size() tasks, in any order and from several threads at once; bytes[i]: about
// what task i holds while it runs, so that whoever runs them can keep within a budget.
using RunTasks =
    std::function<void(std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body)>;

// An image of any size cut into square tiles, those at the far ends smaller; numbered row by row. Only tiles are ever
// held, never the whole. Tiles may be absent: then they are no part of the image, and it ends at their neighbours.
struct TileGrid {
  std::uint32_t width = 0, height = 0;     // of the whole, pixels; below 2^31
  std::uint32_t side = 1024;               // of a tile, pixels
  std::vector<std::uint8_t> present = {};  // of each tile, 1 or 0; empty: all are
  RunTasks run = {};                       // what runs the work on tiles; empty: parallel_for

  std::uint32_t columns() const { return (width + side - 1) / side; }
  std::uint32_t rows() const { return (height + side - 1) / side; }
  std::size_t count() const { return width == 0 || height == 0 ? 0 : std::size_t{columns()} * rows(); }
  bool has(std::size_t tile) const { return present.empty() || present[tile] != 0; }
  // Whether a pixel belongs to the image; any x and y.
  bool holds(std::int64_t x, std::int64_t y) const {
    return x >= 0 && y >= 0 && x < width && y < height &&
           (present.empty() || present[static_cast<std::size_t>(y / side * columns() + x / side)] != 0);
  }
  // The pixels of the image that have a neighbour, of sides and corners, outside of it.
  bool ends_at(std::int64_t x, std::int64_t y) const {
    for (std::int64_t v = y - 1; v <= y + 1; ++v)
      for (std::int64_t u = x - 1; u <= x + 1; ++u)
        if (!holds(u, v)) return true;
    return false;
  }
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

// How much the work on a tile holds: so many bytes for each of its pixels and of so many around it on all sides.
struct TileCost {
  std::uint32_t bytes = 40;
  std::uint32_t halo = 0;
};

// Calls body(i) for tasks of so many bytes, as the grid runs them.
void run_tasks(const TileGrid& grid, std::span<const std::uint64_t> bytes,
               const std::function<void(std::size_t)>& body);

// Calls body(tile) for the tiles that are present.
void for_each_tile(const TileGrid& grid, const std::function<void(std::size_t)>& body, const TileCost& cost = {});

// The caller's access to the tiles that are present, called from several threads at once, for different tiles. Around:
// with so many pixels on all four sides, kNoHeight outside of the image.
using ReadAround = std::function<Image(std::size_t tile, std::uint32_t halo)>;
using ReadTile = std::function<Image(std::size_t tile)>;
using WriteTile = std::function<void(std::size_t tile, const Image& image)>;

}  // namespace ilot
