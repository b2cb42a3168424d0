// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cassert>
#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Calls body(i) once for each of bytes.size() tasks, in any order and from several threads at once. bytes[i] is about
// the memory of task i while it runs, so that the caller can keep within a budget.
using RunTasks =
    std::function<void(std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body)>;

// Called before a table that all tiles share grows by so many bytes. The owner of the budget makes room, or throws.
using NeedBytes = std::function<void(std::uint64_t bytes)>;

// The place of a tile in the raster of tiles. Places are ordered as tiles are numbered.
struct TilePlace {
  std::uint32_t row = 0, column = 0;
  friend auto operator<=>(const TilePlace&, const TilePlace&) = default;
};

constexpr std::size_t kNoTile = ~std::size_t{0};

// An image of any size that is cut into square tiles, with smaller ones at the far ends. Only tiles are ever in memory,
// never the whole image. Tiles may be absent: then they are not part of the image, which ends at their neighbours.
// Present tiles are numbered row by row from 0 to count() - 1. Absent tiles have no number and need no memory.
struct TileGrid {
  std::uint32_t width = 0, height = 0;  // of the whole image, pixels; below 2^31
  std::uint32_t side = 1024;            // of a tile, pixels
  std::vector<TilePlace> tiles = {};    // the present tiles, in order; empty: all are present
  RunTasks run = {};                    // runs the work on tiles; empty: parallel_for
  NeedBytes need = {};                  // empty: memory has no limit

  std::uint32_t columns() const { return (width + side - 1) / side; }
  std::uint32_t rows() const { return (height + side - 1) / side; }
  std::size_t count() const {
    if (!tiles.empty()) return tiles.size();
    return width == 0 || height == 0 ? 0 : std::size_t{columns()} * rows();
  }
  TilePlace place(std::size_t tile) const {
    assert(tile < count());
    if (!tiles.empty()) return tiles[tile];
    return {static_cast<std::uint32_t>(tile / columns()), static_cast<std::uint32_t>(tile % columns())};
  }
  // Returns the number of the tile at any row and column, or kNoTile where there is none. O(log tiles).
  std::size_t tile_at(std::int64_t row, std::int64_t column) const {
    if (row < 0 || column < 0 || row >= rows() || column >= columns()) return kNoTile;
    if (tiles.empty()) return static_cast<std::size_t>(row * columns() + column);
    const TilePlace wanted{static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)};
    const auto found = std::lower_bound(tiles.begin(), tiles.end(), wanted);
    return found != tiles.end() && *found == wanted ? static_cast<std::size_t>(found - tiles.begin()) : kNoTile;
  }
  // Returns the number of the tile of any pixel, or kNoTile outside of the image.
  std::size_t tile_with(std::int64_t x, std::int64_t y) const {
    return x < 0 || y < 0 || x >= width || y >= height ? kNoTile : tile_at(y / side, x / side);
  }
  // Whether any x and y is a pixel of the image.
  bool contains(std::int64_t x, std::int64_t y) const { return tile_with(x, y) != kNoTile; }
  // Whether a pixel has a neighbour outside of the image, across a side or a corner.
  bool ends_at(std::int64_t x, std::int64_t y) const {
    if (x < 1 || y < 1 || x + 1 >= width || y + 1 >= height) return true;
    for (std::int64_t row = (y - 1) / side; row <= (y + 1) / side; ++row)
      for (std::int64_t column = (x - 1) / side; column <= (x + 1) / side; ++column)
        if (tile_at(row, column) == kNoTile) return true;
    return false;
  }
};

struct TileFrame {
  std::uint32_t x, y, width, height;  // x, y: its first pixel in the whole image; width, height: of the tile
};

inline TileFrame tile_frame(const TileGrid& grid, std::size_t tile) {
  const auto [row, column] = grid.place(tile);
  const std::uint32_t x = column * grid.side, y = row * grid.side;
  return {x, y, std::min(grid.side, grid.width - x), std::min(grid.side, grid.height - y)};
}

// Tiles that touch at sides or corners are one group. Groups are numbered from 1 to `count` by their first tiles.
struct TileGroups {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of;  // of each tile
};
TileGroups groups_of(const TileGrid& grid);

// The memory of the work on a tile: so many bytes for each of its pixels and for each pixel of the halo around it.
struct TileCost {
  std::uint32_t bytes = 40;
  std::uint32_t halo = 0;
};

// Calls body(i) for tasks of so many bytes, as the grid runs them.
void run_tasks(const TileGrid& grid, std::span<const std::uint64_t> bytes,
               const std::function<void(std::size_t)>& body);

void need_bytes(const TileGrid& grid, std::uint64_t bytes);

// Calls body(tile) for the tiles that are present.
void for_each_tile(const TileGrid& grid, const std::function<void(std::size_t)>& body, const TileCost& cost = {});

// The caller's access to the present tiles. The functions are called from several threads at once, for different tiles.
// ReadAround returns the tile with a halo of so many pixels on all four sides, kNoHeight outside of the image.
using ReadAround = std::function<Image(std::size_t tile, std::uint32_t halo)>;
using ReadTile = std::function<Image(std::size_t tile)>;
using WriteTile = std::function<void(std::size_t tile, const Image& image)>;

}  // namespace ilot
