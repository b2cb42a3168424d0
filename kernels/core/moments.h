// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/core/eigen3.h"
#include "kernels/core/types.h"

namespace ilot {

using Int128 = __int128;

// Exact sums over integer points. The result does not depend on the order of the points, nor on how they were split
// among blocks and threads. Coordinates are relative to an anchor that the caller keeps. The number of points times the
// widest coordinate must stay below 2^63 (a billion points over a thousand kilometres at a millimetre).
struct Moments {
  std::int64_t n = 0;
  Int128 x = 0, y = 0, z = 0;
  Int128 xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add_point(Index3 p);
  void add(const Moments& m);
  friend bool operator==(const Moments&, const Moments&) = default;
};

// Computes the moments of the points with these indices. Their offsets must be integers below 2^22 in magnitude. O(n).
Moments moments_of(Points points, std::span<const std::uint32_t> indices);

// Returns the moments of the same points relative to another anchor: every coordinate grows by `by`.
Moments shifted(const Moments& m, Index3 by);

Vec3 centroid(const Moments& m);          // n > 0
Symmetric3 covariance(const Moments& m);  // n > 0; about the centroid, divided by n

}  // namespace ilot
