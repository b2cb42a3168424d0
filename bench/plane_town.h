// SPDX-License-Identifier: Apache-2.0
// The point sets on which triangulations are timed: the town seen from above, in Morton order and unordered, and a
// raster of as many points. All cells of the raster are cocircular.
#pragma once
#include "bench/surface.h"
#include "kernels/geometry/point2.h"

namespace ilot::bench {

struct PlanePoints {
  const char* name;
  std::vector<Point2> points;
  float reach;  // reach of alpha shapes, in lattice units
};

inline std::vector<PlanePoints> plane_points(std::size_t n) {
  const Surface s = make_surface(n);
  PlanePoints town{"town", {}, 600}, shuffled{"shuffled town", {}, 600}, raster{"raster", {}, 400};
  for (std::size_t i = 0; i < n; ++i)
    town.points.push_back({static_cast<std::int32_t>(s.x[i]), static_cast<std::int32_t>(s.y[i])});
  shuffled.points = town.points;
  Rng rng(2);
  for (std::size_t i = n; i > 1; --i) std::swap(shuffled.points[i - 1], shuffled.points[rng.below(i)]);
  const auto columns = static_cast<std::int32_t>(std::sqrt(static_cast<double>(n)));
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(n); ++i)
    raster.points.push_back({i % columns * 500, i / columns * 500});
  return {town, shuffled, raster};
}

}  // namespace ilot::bench
