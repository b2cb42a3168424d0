// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/model/point_label.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"

namespace ilot {

// What the points of a building are: roof where one has a face; wall where it has none and is within 0.3 m of a wall of
// the model, not above it; else none, or roof where the model is one level block. Any number of walls: a map of them
// with cells of a metre, wider ones where those would be more than 2^16.
class PointLabeller {
 public:
  PointLabeller(const RoofSite& site, const RoofModel& model, double metres_per_unit);

  // Metres from the site's anchor; the point's face or 0.
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
  double low_x_ = 0, low_y_ = 0, high_x_ = -1, high_y_ = -1, cell_ = 1;  // of the walls and their surroundings
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_, of_cell_;  // per cell the walls that may be near
};

}  // namespace ilot
