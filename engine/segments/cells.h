// SPDX-License-Identifier: Apache-2.0
// Canonical cells: where one connected cloud is everything, planes are found cell by cell. Cells are cubes of a fixed
// metric size, cut into eight where they hold too many points; they depend on the points alone, never on the blocks.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/store/view.h"

namespace ilot {

struct CellSlice {
  std::uint32_t block = 0;
  std::uint32_t first = 0, count = 0;
};

struct Cell {
  Node node;
  std::uint32_t points = 0;
  std::vector<CellSlice> slices;  // its points, in global order
};

constexpr double kCellMetres = 64;                      // largest edge: the power of two of units not above it
constexpr std::uint32_t kCellPoints = std::uint32_t{1} << 18;

// All cells that hold points, in global order.
std::vector<Cell> canonical_cells(const Store& store, double metres_per_unit);

// Points of a cell and of a margin of 1/16 of its edge around it, compact and in global order, as offsets from the
// cell's corner.
struct CellPoints {
  std::vector<float> x, y, z;             // padded as Points asks
  std::vector<std::uint32_t> view_index;  // in the view they were read with
  std::vector<std::uint8_t> core;         // 1 = in the cell itself
  std::size_t size = 0;
  Points points() const { return {x.data(), y.data(), z.data(), size}; }
};
View cell_view(const Store& store, const Cell& cell);
CellPoints cell_points(const View& view, const Cell& cell);

}  // namespace ilot
