// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>

#include "kernels/geometry/flat_box.h"

namespace ilot {

// Whether the segment from a to b has a place in the box, by clipping it to the four sides (Liang and Barsky 1984).
inline bool meets(FlatPoint a, FlatPoint b, const FlatBox& box) {
  double from = 0, to = 1;
  const auto clip = [&](double start, double way, double low, double high) {
    if (way == 0) return start >= low && start <= high;
    const double t0 = (low - start) / way, t1 = (high - start) / way;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
    return from <= to;
  };
  return clip(a.x, b.x - a.x, box.min.x, box.max.x) && clip(a.y, b.y - a.y, box.min.y, box.max.y);
}

}  // namespace ilot
