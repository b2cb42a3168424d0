// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/banded_wall.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot::scan {

std::vector<std::array<double, 2>> solid_intervals(double x0, double x1, double z,
                                                   const std::vector<Opening>& openings) {
  std::vector<std::array<double, 2>> holes;
  for (const Opening& o : openings) {
    if (z <= o.bottom || z >= top_of(o)) continue;
    double half = (o.right - o.left) / 2;
    const double middle = (o.left + o.right) / 2;
    if (z > o.springing) {
      const double radius = arch_radius(o), above = z - (top_of(o) - radius);
      half = std::min(half, std::sqrt(std::max(0.0, radius * radius - above * above)));
    }
    holes.push_back({middle - half, middle + half});
  }
  std::sort(holes.begin(), holes.end());
  std::vector<std::array<double, 2>> solid;
  double from = x0;
  for (const auto& [left, right] : holes) {
    if (left > from) solid.push_back({from, std::min(left, x1)});
    from = std::max(from, right);
  }
  if (from < x1) solid.push_back({from, x1});
  return solid;
}

void add_banded_wall(FacadeBuilder& facade, double x0, double x1, double z0, double z1,
                     const std::vector<Opening>& openings, const Bands& bands, Finish course, Finish joint) {
  const auto element = [&](const char* kind, double low, double high, double depth) {
    TrueElement e;
    e.kind = kind;
    e.ring = facade.outline({x0, x1, low, high, 0}, 0);
    e.width = x1 - x0;
    e.height = high - low;
    e.depth = depth;
    return facade.add_element(e);
  };
  joint.element = element("joint", z0, z1, -bands.depth);
  double low = z0;
  while (low < z1 - 1e-9) {
    const double high = std::min(z1, low + bands.pitch - bands.groove), next = std::min(z1, high + bands.groove);
    course.element = element("course", low, high, 0);
    facade.wall(x0, x1, low, high, 0, openings, course);
    if (next > high + 1e-9) {
      facade.wall(x0, x1, high, next, -bands.depth, openings, joint);
      Finish edge = joint;
      edge.material = course.material;
      for (double z : {high, next})
        for (const auto& [left, right] : solid_intervals(x0, x1, z, openings))
          facade.plate({{left, -bands.depth, z}, {left, 0, z}, {right, 0, z}, {right, -bands.depth, z}}, edge,
                       Faces::unnamed);
    }
    low = next;
  }
}

}  // namespace ilot::scan
