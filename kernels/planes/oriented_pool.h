// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"

namespace ilot {

// The points that have no label yet, side by side and padded as Points asks, and where each comes from.
struct OrientedPool {
  std::vector<float> x, y, z, nx, ny, nz;
  std::vector<std::uint32_t> index;
  OrientedPoints view() const {
    return {{x.data(), y.data(), z.data(), index.size()}, nx.data(), ny.data(), nz.data()};
  }
};

// In the order of the points; label 0 = none. O(n).
inline OrientedPool unlabelled(const OrientedPoints& p, std::span<const std::uint32_t> label) {
  constexpr std::size_t kPadding = 16;
  OrientedPool pool;
  for (std::uint32_t i = 0; i < p.points.size; ++i)
    if (label[i] == 0) pool.index.push_back(i);
  const auto gather = [&](const float* from, std::vector<float>& to) {
    to.reserve(pool.index.size() + kPadding);
    for (const std::uint32_t i : pool.index) to.push_back(from[i]);
    to.resize(pool.index.size() + kPadding, 0.0f);
  };
  gather(p.points.x, pool.x);
  gather(p.points.y, pool.y);
  gather(p.points.z, pool.z);
  gather(p.nx, pool.nx);
  gather(p.ny, pool.ny);
  gather(p.nz, pool.nz);
  return pool;
}

}  // namespace ilot
