// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>

#include "kernels/core/types.h"

namespace ilot {

// What every pass over the store is given.
struct PassContext {
  std::uint64_t budget_bytes = std::uint64_t{1} << 30;  // that the tasks of a pass may hold together
  std::uint64_t memory_bytes = 0;                       // that the whole process may hold (--memory); 0 = not known
  std::uint64_t task_points = std::uint64_t{1} << 21;   // most points that one task should hold at once
  double metres_per_unit = 1;                           // metres per unit of the CRS
  double rounding = 0;                                  // units; most that a point of the store lies beside its input
  Index3 corner;                                        // near the least of all points, those beyond the area too
  std::function<bool(Index3)> wanted;                   // points that products are asked for; empty = all
  std::function<void(std::uint64_t)> advance = [](std::uint64_t) {};  // points done, from any thread
};

}  // namespace ilot
