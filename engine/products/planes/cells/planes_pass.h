// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/cells.h"
#include "engine/settings/settings.h"
#include "kernels/core/moments.h"

namespace ilot {

// What stays in memory of a cell while passes run over the blocks. Lengths in lattice units.
struct CellSummary {
  std::uint32_t first_plane = 0, plane_count = 0;  // among all cell planes
  std::int64_t connectivity = 1;
  std::uint32_t min_points = 3;
  double epsilon = 0;
  double normal_angle = 25;  // degrees
  double step = 0, noise = 0;
  SeenFrom from = SeenFrom::air;
  bool searched_curved = false;  // spheres, cylinders and cones too
};

struct CellPlanes {
  std::vector<CellSummary> cells;      // as the canonical cells
  std::vector<std::uint32_t> cell_of;  // per cell plane: its cell
};

// Finds the planes of each cell, after its curved shapes where these are wanted
// (engine/products/planes/cells/cell_shapes.h), and writes the column "segment" (u32 per point: 0 = none, else 1 +
// number of the cell plane). A cell's answer depends on the points of the cell and its margin alone. The palette (with
// the column "colour") is for colour_ransac.
CellPlanes planes_pass(const Store& store, const std::vector<Cell>& cells, const Settings& settings,
                       const PassContext& context, const ColourPalette& palette = {});

// Removes what planes_pass keeps of a cell's planes, so that it looks for them again.
void forget_cell(const Store& store, const Cell& cell);

// A plane of one cell before the join, as it is kept on disk. Coordinates relative to the cell's corner.
struct CellPlane {
  Plane plane;      // fitted over the cell and its margin
  Moments moments;  // of its points in the cell itself
};

// The planes of one cell, which planes_pass has found.
std::vector<CellPlane> read_cell_planes(const Store& store, const Cell& cell);

}  // namespace ilot
