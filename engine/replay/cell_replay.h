// SPDX-License-Identifier: Apache-2.0
// Repeats the search for planes in one cell.
#pragma once
#include <string>
#include <vector>

#include "engine/model/layer.h"
#include "engine/products/planes/cells/planes_pass.h"
#include "engine/replay/kept_run.h"
#include "engine/replay/picture.h"

namespace ilot {

// A point of the cell itself.
struct CellPoint {
  Vec3 at;      // CRS
  Vec3 normal;  // unit length; zero = no normal
  double curvature = 0;
  std::uint32_t segment = 0;  // 0 = none, else 1 + index among the planes of the cell before the join
  std::uint32_t plane = 0;    // plane_id; 0 = none
};

struct CellReplay {
  Index3 corner;                                   // the lowest one, on the lattice
  double edge = 0, unit = 0, metres_per_unit = 1;  // CRS units; a lattice unit
  CellSummary summary;
  std::vector<CellPlane> planes;
  std::vector<CellPoint> points;
  std::vector<std::string> differences;  // from the columns of the kept store
};

// Computes normals, planes and labels of the blocks that contain the cell again; the planes of other cells are those of
// the run. `id` is "X,Y,Z", lattice units of the lowest corner, or "at:E,N,H". Throws a usage Error when there is no
// such cell.
CellReplay replay_cell(const KeptRun& run, const std::string& id, Progress& progress);

// Returns the cell, its points, and its planes before the join.
std::vector<Layer> layers_of(const CellReplay& cell);

std::vector<Picture> pictures_of(const CellReplay& cell);

// Returns names, places and sizes of the cells.
std::vector<std::string> cells_to_replay(const Store& store, const PassContext& context);

}  // namespace ilot
