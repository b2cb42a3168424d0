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
  Vec3 middle(std::size_t cell) const;  // its z is 0
};

// The cells of the density, and the windows of the step, for a number of points in a box.
MeasureGrid density_cells(Vec3 min, Vec3 max, double points);
MeasureGrid step_windows(Vec3 min, Vec3 max, double points);

// The occupied windows with the smallest keys. One reading is enough for a fair choice, because a window that is
// replaced once is never selected again. Of each window the points nearest to its middle are kept, so that they lie
// together; no result depends on the order of points or on the parts in which they were added.
class SampledWindows {
 public:
  // Points and windows have the same units, which are `metres` long along each axis.
  SampledWindows(const MeasureGrid& windows, Vec3 origin, Vec3 metres);

  void add(Vec3 p);
  void add(const SampledWindows& other);  // of the same windows
  double median_step();                   // metres to the nearest point elsewhere; 0 without a point

 private:
  struct Window {
    Vec3 middle;               // metres from the origin; its z has no meaning
    std::vector<Vec3> points;  // metres from the origin
  };
  Window* window_of(std::size_t cell);
  Window* kept(std::uint64_t key);

  MeasureGrid windows_;
  Vec3 origin_, metres_;
  std::map<std::uint64_t, Window> kept_;
};

}  // namespace ilot
