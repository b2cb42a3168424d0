// SPDX-License-Identifier: Apache-2.0
// The plain data that kernels work on. A kernel is a pure function over these views: it owns nothing and keeps nothing.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "ilot/geometry.h"

namespace ilot {

// Integer lattice point, in scale units. int64: national grids at a millimetre do not fit 32 bits.
struct Index3 {
  std::int64_t x = 0, y = 0, z = 0;
  friend bool operator==(const Index3&, const Index3&) = default;
};

// Closed box of lattice points. Empty when any max < min.
struct IndexBox {
  Index3 min, max;
  bool contains(Index3 p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z && p.z <= max.z;
  }
  bool intersects(const IndexBox& o) const {
    return min.x <= o.max.x && o.min.x <= max.x && min.y <= o.max.y && o.min.y <= max.y && min.z <= o.max.z &&
           o.min.z <= max.z;
  }
  IndexBox grown(std::int64_t by) const {
    return {{min.x - by, min.y - by, min.z - by}, {max.x + by, max.y + by, max.z + by}};
  }
  friend bool operator==(const IndexBox&, const IndexBox&) = default;
};

// Structure-of-arrays view of n points: offsets in scale units from an anchor that the caller knows. Integers held in
// float32, exact below 2^24. The arrays are readable (any finite value) up to the next multiple of 16 elements.
struct Points {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  std::size_t size = 0;
};

}  // namespace ilot
