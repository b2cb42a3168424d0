// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/cells.h"
#include "engine/settings/settings.h"
#include "kernels/core/moments.h"

namespace ilot {

// The data of a cell that stay in memory while passes run over the blocks. Lengths are in lattice units.
struct CellSummary {
  std::uint32_t first_plane = 0, plane_count = 0;  // numbers among all cell planes
  std::int64_t connectivity = 1;
  std::uint32_t min_points = 3;
  double epsilon = 0;
  double normal_angle = 25;  // degrees
  double step = 0, noise = 0;
  SeenFrom from = SeenFrom::air;
  bool searched_curved = false;  // whether spheres, cylinders and cones were searched for too
};

struct CellPlanes {
  std::vector<CellSummary> cells;      // in the order of the canonical cells
  std::vector<std::uint32_t> cell_of;  // for each cell plane its cell
};

// Finds the planes of each cell, after its curved shapes where these are wanted
// (engine/products/planes/cells/cell_shapes.h). Writes the column "segment" (u32 per point: 0 = none, else 1 + number
// of the cell plane). The result of a cell depends only on the points of the cell and its margin. The palette (with the
// column "colour") is used by colour_ransac.
CellPlanes planes_pass(const Store& store, const std::vector<Cell>& cells, const Settings& settings,
                       const PassContext& context, const ColourPalette& palette = {});

// The file in which planes_pass keeps what it found in a cell; cells that have it are not searched again. Beside it is
// shapes_path() of cells in which curved shapes were found.
std::filesystem::path cell_path(const Store& store, const Cell& cell);

// Removes what planes_pass has stored of the planes of a cell, so that they are searched for again.
void forget_cell(const Store& store, const Cell& cell);

// A plane of one cell before the join, as it is stored. Coordinates are relative to the corner of the cell.
struct CellPlane {
  Plane plane;      // fitted over the cell and its margin
  Moments moments;  // of its points in the cell itself
};

// Reads the planes of one cell that planes_pass has found.
std::vector<CellPlane> read_cell_planes(const Store& store, const Cell& cell);

}  // namespace ilot
