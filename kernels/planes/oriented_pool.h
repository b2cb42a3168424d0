// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/padded_points.h"

namespace ilot {

// The points that have no label yet, stored side by side and padded as Points requires, with the index of each.
struct OrientedPool : PaddedOrientedPoints {
  std::vector<std::uint32_t> index;
};

// Returns the points with label 0 in their order. O(n).
inline OrientedPool unlabelled(const OrientedPoints& p, std::span<const std::uint32_t> label) {
  OrientedPool pool;
  for (std::uint32_t i = 0; i < p.points.size; ++i)
    if (label[i] == 0) pool.index.push_back(i);
  pool.reserve(pool.index.size());
  for (const std::uint32_t i : pool.index) pool.add_from(p, i);
  pool.pad();
  return pool;
}

}  // namespace ilot
