// SPDX-License-Identifier: Apache-2.0
// The plain data that kernels work on. A kernel is a pure function over these views. It owns nothing and keeps nothing.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "ilot/geometry.h"

namespace ilot {

// Integer lattice point, in scale units. Coordinates are int64 because national grids at a millimetre do not fit 32
// bits.
struct Index3 {
  std::int64_t x = 0, y = 0, z = 0;
  friend bool operator==(const Index3&, const Index3&) = default;
};

// Structure-of-arrays view of n points. The values are offsets in scale units from an anchor that the caller knows.
// They are integers stored as float32, exact below 2^24. The arrays are readable (any finite value) up to the next
// multiple of 16 elements.
struct Points {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  std::size_t size = 0;
};

// Points with unit normals. A point without a normal has (0, 0, 0). The arrays are null when there are no normals at
// all.
struct OrientedPoints {
  Points points;
  const float* nx = nullptr;
  const float* ny = nullptr;
  const float* nz = nullptr;
};

}  // namespace ilot
