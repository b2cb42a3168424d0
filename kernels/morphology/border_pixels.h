// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels. The pixels on the borders of all tiles of a grid form one list, tile after tile. The
// pixels of a tile are in the order of its Perimeter.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/morphology/perimeter.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

class BorderPixels {
 public:
  explicit BorderPixels(const TileGrid& grid) : grid_(grid), first_(grid.count() + 1, 0) {
    for (std::size_t t = 0; t < grid.count(); ++t) first_[t + 1] = first_[t] + perimeter(t).size();
    assert(first_.back() < (std::size_t{1} << 32));
  }

  const TileGrid& grid() const { return grid_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(first_.back()); }
  std::uint32_t first(std::size_t tile) const { return static_cast<std::uint32_t>(first_[tile]); }

  Perimeter perimeter(std::size_t tile) const {
    const TileFrame frame = tile_frame(grid_, tile);
    return {frame.width, frame.height};
  }

  std::size_t tile_of(std::uint32_t pixel) const {
    return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), pixel) - first_.begin() - 1);
  }

  // Whether pixel i of the perimeter of a tile has a neighbour outside of the image, across a side or a corner.
  bool ends_at(std::size_t tile, std::uint32_t i) const {
    const TileFrame frame = tile_frame(grid_, tile);
    const auto [x, y] = perimeter(tile).place(i);
    return grid_.ends_at(std::int64_t{frame.x} + x, std::int64_t{frame.y} + y);
  }

  // Calls take(q) for the neighbours of a border pixel that are in other tiles.
  template <typename Take>
  void for_beyond(std::uint32_t pixel, Adjacency adjacency, const Take& take) const {
    const std::size_t tile = tile_of(pixel);
    const TileFrame frame = tile_frame(grid_, tile);
    const auto [tx, ty] = perimeter(tile).place(pixel - first(tile));
    const std::int64_t x = std::int64_t{frame.x} + tx, y = std::int64_t{frame.y} + ty;
    for (std::int64_t qy = y - 1; qy <= y + 1; ++qy) {
      for (std::int64_t qx = x - 1; qx <= x + 1; ++qx) {
        if (adjacency == Adjacency::four && qx != x && qy != y) continue;
        if (inside(frame, qx, qy)) continue;
        const std::size_t other = grid_.tile_with(qx, qy);
        if (other != kNoTile) take(at(other, qx, qy));
      }
    }
  }

 private:
  static bool inside(const TileFrame& frame, std::int64_t x, std::int64_t y) {
    return x >= frame.x && y >= frame.y && x < std::int64_t{frame.x} + frame.width &&
           y < std::int64_t{frame.y} + frame.height;
  }
  std::uint32_t at(std::size_t tile, std::int64_t x, std::int64_t y) const {
    const TileFrame frame = tile_frame(grid_, tile);
    return first(tile) +
           perimeter(tile).index(static_cast<std::uint32_t>(x - frame.x), static_cast<std::uint32_t>(y - frame.y));
  }

  TileGrid grid_;
  std::vector<std::size_t> first_;
};

}  // namespace ilot
