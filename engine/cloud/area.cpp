// SPDX-License-Identifier: Apache-2.0
#include "engine/cloud/area.h"

namespace ilot {
namespace {

// Does the half-open edge cross the ray from the point to the right?
bool crosses(const std::array<double, 2>& a, const std::array<double, 2>& b, double x, double y) {
  if ((a[1] > y) == (b[1] > y)) return false;
  return x < a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
}

}  // namespace

bool Area::contains(double x, double y) const {
  if (!(x >= min_x && x <= max_x && y >= min_y && y <= max_y)) return false;
  if (rings.empty()) return true;
  bool inside = false;
  for (const AreaRing& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      // The lower end first, so that an edge shared by two rings is judged alike in both directions.
      const auto& p = ring[i];
      const auto& q = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (p[1] <= q[1] ? crosses(p, q, x, y) : crosses(q, p, x, y)) inside = !inside;
    }
  }
  return inside;
}

}  // namespace ilot
