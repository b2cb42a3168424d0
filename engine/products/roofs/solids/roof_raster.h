// SPDX-License-Identifier: Apache-2.0
// A model of a building beside the points from which it was made, cell by cell in plan.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"

namespace ilot {

// Cells are half a metre wide, or two sampling steps where the points are farther apart. A cell has a roof where its
// centre is below a face of the model. Memory: 24 bytes per cell, and at most 2^16 cells.
class RoofRaster {
 public:
  // `level` is the height of the roof of LoD1.2 above the site's anchor. It is used where the model has no faces.
  RoofRaster(const RoofSite& site, const RoofModel& model, double level);

  // Adds a point (metres from the anchor). `off`: it lies off the model.
  void add(Vec3 p, bool off);

  // The share of the roof's cells that have no point within 1 m of the roof at their centre. 0 without a roof.
  double bare_share() const;

  // The area (m2) of the largest set of connected cells most of whose points lie off the model. Cells that share a
  // corner are connected.
  double largest_off() const;

  // How far the roof rises above all points that are near it in plan: metres, 0 at least. Near is a metre, or a cell
  // where that is more.
  double overshoot() const;

 private:
  struct Cell {
    double roof, highest;                      // metres; NaN and -infinity where there is none
    std::uint32_t off : 31 = 0, seen : 1 = 0;  // seen: a point is within 1 m of the roof
    std::uint32_t on = 0;
  };
  std::int64_t column(double x) const;
  std::int64_t row(double y) const;
  bool is_off(std::size_t cell) const { return cells_[cell].off > cells_[cell].on; }

  double low_x_ = 0, low_y_ = 0, width_ = 1, reach_ = 1;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace ilot
