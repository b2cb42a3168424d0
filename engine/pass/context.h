// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>

#include "kernels/core/types.h"

namespace ilot {

// The parameters that every pass over the store gets.
struct PassContext {
  std::uint64_t budget_bytes = std::uint64_t{1} << 30;  // memory for all tasks of a pass together
  std::uint64_t memory_bytes = 0;                       // memory for the whole process (--memory); 0 = not known
  std::uint64_t task_points = std::uint64_t{1} << 21;   // greatest number of points that one task should keep at once
  double metres_per_unit = 1;                           // metres per unit of the CRS
  double rounding = 0;                 // CRS units; greatest distance of a point of the store from its input
  Index3 corner;                       // near the smallest coordinates of all points, also of those outside the area
  std::function<bool(Index3)> wanted;  // points for which products are asked; empty = all
  std::function<void(std::uint64_t)> advance = [](std::uint64_t) {};  // points done; from any thread
};

}  // namespace ilot
