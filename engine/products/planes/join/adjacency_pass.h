// SPDX-License-Identifier: Apache-2.0
// Finds which planes touch, where and how.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/model/segment.h"
#include "engine/products/planes/join/join_pass.h"

namespace ilot {

// The place where two planes touch, summed over the cubes that contain points of both.
struct Touch {
  std::uint32_t a = 0, b = 0;  // plane ids, a < b
  double length = 0;           // units
  double places = 0;           // number of cubes
  Vec3 place;                  // sum of the centres of the cubes, units, relative to the anchor of plane a
};

// Planes touch where points of both lie in one small cube. The cubes divide each canonical cell. Their edge is between
// one and two times the connectivity of the cell. They are on two lattices that are half an edge apart, so that no edge
// of a building is missed between them. The result depends on the labels and the canonical cells alone. Planes that
// touch only across the border of two cells are not counted there. `final_id` has one value per label of the column
// "plane", 0 = none; `planes` is ordered by id. Writes the column "touches". O(n log n) per cell.
void adjacency_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                    const std::vector<std::uint32_t>& final_id, const std::vector<JoinedPlane>& planes,
                    const PassContext& context);

// Gives the touches of at least three cubes over all cells, in ascending order of (a, b). The memory is that of the
// touches of some planes at a time.
void each_touch(const Store& store, const std::function<void(const Touch&)>& take);

// What a touch shows about the two planes.
PlaneNeighbours neighbours_of(const Touch& touch, const JoinedPlane& a, const JoinedPlane& b, double unit,
                              double metres_per_unit);

}  // namespace ilot
