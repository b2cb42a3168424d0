// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/model/point_label.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"
#include "kernels/core/lists_by_key.h"

namespace ilot {

// Labels the points of a building. A point that has a face is roof. A point without a face that is within 0.3 m of a
// wall of the model, and not above it, is wall. Any other point is none, or roof where the model is one level block.
// There may be any number of walls: they are in a map with cells of a metre, or wider cells where there would be more
// than 2^16.
class PointLabeller {
 public:
  PointLabeller(const RoofSite& site, const RoofModel& model, double metres_per_unit);

  // Labels a point in metres from the site's anchor; `face` is its face or 0.
  PointLabel label(Vec3 p, std::uint32_t face) const;

 private:
  struct Wall {
    double x, y, dx, dy, top;
  };
  void add_walls(const RoofSite& site, const Building& building, double metres_per_unit);
  void map_walls();
  template <class Visit>
  void for_each_cell(const Wall& wall, const Visit& visit) const;
  std::size_t column(double x) const;
  std::size_t row(double y) const;

  bool level_ = false;
  std::vector<Wall> walls_;
  double low_x_ = 0, low_y_ = 0, high_x_ = -1, high_y_ = -1, cell_ = 1;  // area of the walls; side of a cell
  std::size_t columns_ = 0, rows_ = 0;
  ListsByKey near_;  // the walls that may be near each cell
};

}  // namespace ilot
