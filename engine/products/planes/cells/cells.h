// SPDX-License-Identifier: Apache-2.0
// Canonical cells: planes are found cell by cell, because the whole cloud may be one connected part. Cells are cubes of
// a fixed metric size. A cell that contains too many points is cut into eight. Cells depend on the points alone, never
// on the blocks.
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

// Choice: a cell of usual density fits into memory and contains whole walls; planes are joined over cells.
constexpr double kCellMetres = 64;  // greatest edge: the largest power of two of units that does not exceed it
constexpr std::uint32_t kCellPoints = std::uint32_t{1} << 18;

// The edge of the largest cells, in units.
std::int64_t largest_cell(double unit_metres);

// All cells that contain points, in global order.
std::vector<Cell> canonical_cells(const Store& store, double metres_per_unit);

// A stretch of a block that belongs to one cell.
struct CellPiece {
  std::uint32_t cell = 0, offset = 0;  // offset of its first point among the points of the cell
  CellSlice slice;
};

// The pieces of each block, in the order of the cells.
std::vector<std::vector<CellPiece>> pieces_of_blocks(const Store& store, const std::vector<Cell>& cells);

// The depth of the margin around a cell that is read with it: 1/16 of its edge, in units.
std::int64_t margin_of(const Cell& cell);

// The approximate greatest number of points that load_cell gives for a cell: its own points and those of the chunks of
// its margin. There are more only where more than kCellPoints points of the margin coincide.
std::uint64_t points_to_load(const Store& store, const Cell& cell);

// The points of a cell and of its margin, compact and in global order, as offsets from the corner of the cell. A margin
// of more than kCellPoints points is thinned to about that number by a hash of their codes. Therefore a cell never has
// more than twice kCellPoints points (unless more coincide). The points are read in small batches.
struct CellPoints : PaddedPoints {
  std::vector<PackedNormal> normals;
  std::vector<std::uint8_t> core;           // 1 = in the cell itself
  std::vector<std::uint32_t> colour_class;  // empty where there is no palette
};
CellPoints load_cell(const Store& store, const Cell& cell, const ColourPalette& palette = {});

}  // namespace ilot
