// SPDX-License-Identifier: Apache-2.0
// Cuts the points and the sites of a run into areas with one owner each.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/scale/chunk_boxes.h"
#include "engine/scale/plan.h"
#include "engine/store/store.h"

namespace ilot {

// How many points of a store lie in squares of the plan, and where the chunks of each input are.
struct PointMap {
  int bits = 0;  // the side of a square is 2^bits lattice steps
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint64_t> squares;  // row, column
  std::vector<ChunkBoxes> inputs;

  std::uint64_t in(const IndexBox& box) const;  // points in all squares that meet the box
};
// `chunks` are those of the inputs, with empty boxes.
PointMap map_points(const Store& store, std::vector<ChunkBoxes> chunks, const PassContext& context);

// The side of areas in metres that suits the points: few enough points for one task, and so large that halos are a
// small part.
double suitable_area_size(const PointMap& map, double step_metres, double halo);

// The sites of an area, by their numbers: its own, ascending, and the neighbours whose outlines matter to them.
struct AreaSites {
  PlanArea area;
  std::vector<std::size_t> own, neighbours;
};

// What an area needs to be cut, in metres.
struct AreaParams {
  double size = 0;   // side of the squares
  double halo = 0;   // of points around the outlines of its own sites
  double reach = 0;  // of outlines around them
};

// What areas of cells need to be cut, in lattice steps.
struct CellAreaParams {
  std::int64_t cell = 1;   // edge of the largest cells
  std::int64_t cells = 1;  // of these along a side of an area
  std::int64_t halo = 0;   // of points around the cells of an area
};

// Returns the squares of whole cells that have points, ordered by row and column. Their borders are multiples of the
// edge of a cell, so each cell of a run lies in one of them.
std::vector<PlanArea> cut_cell_areas(const PointMap& map, const CellAreaParams& params);

// Gives the sites to the areas of cells, of the same size, and to further ones where sites lie in none of them. Returns
// all of these, ordered by row and column; one where there are neither cells nor sites. A site without an outline
// belongs to the first. The result is a function of the sites and the cells alone; `step_metres` is the lattice step.
std::vector<AreaSites> cut_areas(std::span<const PlannedSite> sites, std::vector<PlanArea> cells, double step_metres,
                                 const AreaParams& params);

}  // namespace ilot
