// SPDX-License-Identifier: Apache-2.0
// The density and the sampling step of the points of a run, in parts.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/pass/sampled_windows.h"
#include "ilot/cloud_info.h"
#include "kernels/geometry/box3.h"

namespace ilot {

class MeasuredCells {
 public:
  // `box` and `points` are those of all points, in lattice steps; they are the same in all parts of one measure.
  MeasuredCells(const IndexBox& box, std::uint64_t points, double step_metres);

  void add(Index3 p);
  void add_class(std::uint8_t code);
  void add_echoes(std::uint8_t echoes);
  void add(const MeasuredCells& next);

  // After all parts were added, in any order. Without a class that was added all are 0, without echoes
  // all points are last returns. O(points of the windows x log).
  CloudMeasure measure();

 private:
  Vec3 min_, max_;  // metres
  std::uint64_t points_;
  double step_metres_;
  MeasureGrid cells_;  // of the density
  std::vector<bool> occupied_;
  SampledWindows windows_;
  std::array<std::uint64_t, 256> classes_{};
  std::uint64_t not_last_ = 0;
};

}  // namespace ilot
