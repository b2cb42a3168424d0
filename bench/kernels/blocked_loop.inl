// SPDX-License-Identifier: Apache-2.0
// The body of all variants; included with BLOCKED_LOOP, the name of one.
#include <algorithm>
#include <cmath>

#include "bench/kernels/blocked_loop.h"

namespace ilot::bench {

void BLOCKED_LOOP(Points points, std::span<const PlaneHypothesis> planes, float distance,
                  std::span<std::uint32_t> counts) {
  constexpr std::size_t kBlock = 2048;  // 24 kB, the first cache
  for (std::uint32_t& count : counts) count = 0;
  for (std::size_t begin = 0; begin < points.size; begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, points.size);
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const float a = planes[p][0], b = planes[p][1], c = planes[p][2], d = planes[p][3];
      std::uint32_t count = 0;
      for (std::size_t i = begin; i < end; ++i)
        count += std::fabs(a * points.x[i] + b * points.y[i] + c * points.z[i] + d) <= distance;
      counts[p] += count;
    }
  }
}

}  // namespace ilot::bench
