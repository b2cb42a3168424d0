// SPDX-License-Identifier: Apache-2.0
#include "scan/models/plan_hull.h"

#include "kernels/geometry/point2.h"
#include "kernels/outlines/hull.h"

namespace ilot::scan {

std::vector<FlatPoint> plan_hull(std::span<const FlatPoint> points, double steps_per_unit) {
  std::vector<Point2> lattice;
  for (const FlatPoint& p : points) lattice.push_back(lattice_point(p, steps_per_unit));
  std::vector<FlatPoint> hull;
  for (const std::uint32_t i : convex_hull(lattice))
    hull.push_back(
        {static_cast<double>(lattice[i].x) / steps_per_unit, static_cast<double>(lattice[i].y) / steps_per_unit});
  return hull;
}

}  // namespace ilot::scan
