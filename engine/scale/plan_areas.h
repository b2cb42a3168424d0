// SPDX-License-Identifier: Apache-2.0
// Cuts the points and the sites of a run into areas with one owner each.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/sites/site_plan.h"
#include "engine/scale/plan.h"
#include "engine/scale/survey/point_map.h"

namespace ilot {

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
