// SPDX-License-Identifier: Apache-2.0
// Cells: the coarse raster of a street, on which terrain and buildings are found. A cell is a square of pixels, and the
// images of cells are layers of the same tiles.
#pragma once
#include <bit>
#include <cassert>
#include <cstdint>

#include "engine/tiles/raster_scale.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

// Choice: a person fills a cell, and a wall crosses one; larger cells join what stands side by side.
constexpr double kLeastCell = 0.4;  // metres
// Choice: the lowest of so many points is on the ground where half of them are; below crowns fewer are.
constexpr double kLeastPointsOfCell = 5;

struct Cells {
  std::uint32_t factor = 8;  // pixels along the side of a cell, a power of two
  RasterScale scale;         // `pixel` is the side of a cell
  TileLayers layers;         // the layers of the raster of pixels, with the grid of cells

  std::uint32_t side() const { return layers.grid.side; }
  // The cell of a pixel of a tile of `width` pixels, both numbered row by row. The width is a power of two as the
  // factor is, so that nothing is divided.
  std::size_t cell_of(std::size_t pixel, std::uint32_t width) const {
    assert(std::has_single_bit(width) && factor <= width);
    const int of_width = std::countr_zero(width), of_cell = std::countr_zero(factor);
    const std::size_t row = pixel >> (of_width + of_cell), column = (pixel & (width - 1)) >> of_cell;
    return (row << (of_width - of_cell)) + column;
  }
};

// The cells of a raster of pixels, for a density in points a square metre. The side of a cell is the smallest power of
// two in pixels that is no shorter than kLeastCell and holds kLeastPointsOfCell points. `layers` must outlive the
// result.
Cells cells_of(const TileLayers& layers, const RasterScale& scale, double density);

}  // namespace ilot
