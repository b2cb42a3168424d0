// SPDX-License-Identifier: Apache-2.0
// Where the sampling step of a cloud is measured: the same windows whether a file is read or the store of a run.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

constexpr std::size_t kCellsPerSide = 512;  // greatest number of cells per side of the density grid

// Square cells over a box, about `wanted` of them if the cloud filled it.
struct MeasureGrid {
  double x = 0, y = 0, side = 1;
  std::size_t columns = 1, rows = 1;

  MeasureGrid(Vec3 min, Vec3 max, double wanted, double most_per_side);
  std::size_t cell(Vec3 p) const;
};

// The cells of the density, and the windows of the step, for a number of points in a box.
MeasureGrid density_cells(Vec3 min, Vec3 max, double points);
MeasureGrid step_windows(Vec3 min, Vec3 max, double points);

// The occupied windows with the smallest keys. One reading is enough for a fair choice, because a window that is
// replaced once is never selected again. Of each window the first points are kept.
class SampledWindows {
 public:
  void add(std::size_t window, Vec3 p);
  // Adds the windows of the points that come next. The result is that of one reading of all.
  void add(const SampledWindows& next);
  double median_step();  // distance to the nearest point elsewhere; 0 without a point

 private:
  std::vector<Vec3>* points_of(std::uint64_t key);
  std::map<std::uint64_t, std::vector<Vec3>> points_;
};

}  // namespace ilot
