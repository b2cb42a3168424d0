// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/segments/cells.h"
#include "engine/settings/settings.h"
#include "kernels/core/moments.h"

namespace ilot {

// A plane of one cell before the join. Lengths in lattice units, coordinates relative to the cell's corner.
struct CellPlane {
  std::uint32_t cell = 0;  // index into the cells
  Plane plane;             // fitted over the cell and its margin
  double epsilon = 0;
  Moments moments;         // of its points in the cell itself
};

struct CellSummary {
  std::uint32_t first_plane = 0, plane_count = 0;  // in the list of all cell planes
  std::int64_t connectivity = 1;                   // units
  double step = 0, noise = 0;                      // units
};

struct CellPlanes {
  std::vector<CellSummary> cells;   // as the canonical cells
  std::vector<CellPlane> planes;    // by cell
};

// Finds the planes of each cell and writes the column "segment" (u32 per point: 0 = none, else 1 + index into planes).
// A cell's answer depends on the points of the cell and its margin alone.
CellPlanes planes_pass(const Store& store, const std::vector<Cell>& cells, const Settings& settings,
                       const PassContext& context);

}  // namespace ilot
