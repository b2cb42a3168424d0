// SPDX-License-Identifier: Apache-2.0
// Which planes touch, where and how.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/model/segment.h"
#include "engine/products/planes/join/join_pass.h"

namespace ilot {

// Where two planes touch, summed over the cells of space that hold points of both.
struct Touch {
  std::uint32_t a = 0, b = 0;  // plane ids, a < b
  double length = 0;           // units
  double places = 0;           // cells of space
  Vec3 place;                  // sum of their centres, units, relative to the anchor of plane a
};

// Planes touch where points of both lie in one small cube: cubes are cut out of each canonical cell, as wide as its
// connectivity or up to twice that, on two lattices half an edge apart, so that no edge of a building hides between
// them. Depends on the labels and the canonical cells alone; planes that touch only across the border of two cells do
// not count there. `final_id` per label of the column "plane", 0 = none; `planes` by id. Writes the column "touches".
// O(n log n) a cell.
void adjacency_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                    const std::vector<std::uint32_t>& final_id, const std::vector<JoinedPlane>& planes,
                    const PassContext& context);

// The touches of at least three cubes over all cells, ascending by (a, b). Memory: those of some planes at a time.
void each_touch(const Store& store, const std::function<void(const Touch&)>& take);

// What a touch says about the two planes.
PlaneNeighbours neighbours_of(const Touch& touch, const JoinedPlane& a, const JoinedPlane& b, double unit,
                              double metres_per_unit);

}  // namespace ilot
