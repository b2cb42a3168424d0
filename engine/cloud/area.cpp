// SPDX-License-Identifier: Apache-2.0
#include "engine/cloud/area.h"

#include "kernels/geometry/ring.h"

namespace ilot {
bool Area::contains(double x, double y) const {
  if (!(x >= min_x && x <= max_x && y >= min_y && y <= max_y)) return false;
  if (rings.empty()) return true;
  bool inside = false;
  for (const AreaRing& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      // The lower end comes first, so that an edge that two rings share gives the same result in both directions.
      const auto& p = ring[i];
      const auto& q = ring[i + 1 == ring.size() ? 0 : i + 1];
      const FlatPoint a{p[0], p[1]}, b{q[0], q[1]};
      inside ^= a.y <= b.y ? ray_crosses_by_share({x, y}, a, b) : ray_crosses_by_share({x, y}, b, a);
    }
  }
  return inside;
}

}  // namespace ilot
