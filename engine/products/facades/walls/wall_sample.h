// SPDX-License-Identifier: Apache-2.0
// A small picture of a wall and of what is around it, from which its street side is judged.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// Where a wall has points, by cells, and a sample of the points off it: one point of each cube of 10 cm at most.
struct WallSample {
  double width = 0, height = 0;  // metres
  double cell = 0.05;            // metres
  std::int64_t columns = 0, rows = 0;
  std::vector<std::uint8_t> wall;  // per cell: 0 not seen, 1 a point of the wall, 2 wall on all four sides too
  std::vector<Vec3> off;           // points before and behind the wall, in its axes, ascending by u, v, w

  bool seen(std::int64_t row, std::int64_t column) const {
    return wall[static_cast<std::size_t>(row * columns + column)] != 0;
  }
  // The cell of a place within the columns and rows.
  std::size_t cell_at(double u, double v) const {
    return static_cast<std::size_t>(static_cast<std::int64_t>(v / cell) * columns +
                                    static_cast<std::int64_t>(u / cell));
  }
  // Whether a line through this place of the wall's plane meets the wall for certain.
  bool solid(double u, double v) const {
    if (!(u >= 0 && v >= 0 && u < static_cast<double>(columns) * cell && v < static_cast<double>(rows) * cell))
      return false;
    return wall[cell_at(u, v)] == 2;
  }
};

// Reads the points once. O(points); memory: 2^20 cells and 2^16 points at most. Which points are in the sample depends
// on their places only.
WallSample sample_wall(const FacadeSite& site, const FacadePointSource& points);

}  // namespace ilot
