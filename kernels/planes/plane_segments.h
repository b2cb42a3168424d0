// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// What every method of plane extraction returns.
struct PlaneSegments {
  std::vector<std::uint32_t> label;  // per point: 0 = none, else 1 + index into planes
  std::vector<Plane> planes;         // unit normals that point up, in the frame of the points
};

}  // namespace ilot
