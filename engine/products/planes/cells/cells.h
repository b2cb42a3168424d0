// SPDX-License-Identifier: Apache-2.0
// Canonical cells: where one connected cloud is everything, planes are found cell by cell. Cells are cubes of a fixed
// metric size, cut into eight where they hold too many points; they depend on the points alone, never on the blocks.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/columns/colours_pass.h"
#include "engine/pass/context.h"
#include "engine/store/view.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/normals.h"

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

constexpr double kCellMetres = 64;  // largest edge: the power of two of units not above it
constexpr std::uint32_t kCellPoints = std::uint32_t{1} << 18;

// All cells that hold points, in global order.
std::vector<Cell> canonical_cells(const Store& store, double metres_per_unit);

// A stretch of a block that what is stored of a cell tells about.
struct CellPiece {
  std::uint32_t cell = 0, offset = 0;  // of its first point among those of the cell
  CellSlice slice;
};

// Per block, in the order of the cells.
std::vector<std::vector<CellPiece>> pieces_of_blocks(const Store& store, const std::vector<Cell>& cells);

// Depth of the margin around a cell that is looked at along with it: 1/16 of its edge, in units.
std::int64_t margin_of(const Cell& cell);

// About how many points load_cell gives for a cell, at most: its own, and those of the chunks of its margin. More only
// where more than kCellPoints of the margin coincide.
std::uint64_t points_to_load(const Store& store, const Cell& cell);

// Points of a cell and of its margin, compact and in global order, as offsets from the cell's corner. A margin of more
// than kCellPoints points is thinned to about that many by a hash of their codes, so a cell never holds more than twice
// kCellPoints (unless more coincide). Reads in small batches.
struct CellPoints : PaddedPoints {
  std::vector<PackedNormal> normals;
  std::vector<std::uint8_t> core;           // 1 = in the cell itself
  std::vector<std::uint32_t> colour_class;  // empty where there is no palette
};
CellPoints load_cell(const Store& store, const Cell& cell, const ColourPalette& palette = {});

}  // namespace ilot
