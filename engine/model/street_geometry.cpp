// SPDX-License-Identifier: Apache-2.0
#include "engine/model/street_geometry.h"

#include "kernels/core/portable_math.h"

namespace ilot {

std::array<Vec3, 4> extent_of(const StreetObject& o, double metres_per_unit) {
  const double c = cos_degrees(o.heading_deg), s = cos_degrees(o.heading_deg - 90);
  const double l = o.length_m / metres_per_unit / 2, w = o.width_m / metres_per_unit / 2;
  const auto corner = [&](double along, double across) {
    return Vec3{o.middle.x + along * c - across * s, o.middle.y + along * s + across * c, o.middle.z};
  };
  return {corner(-l, -w), corner(l, -w), corner(l, w), corner(-l, w)};
}

std::array<Vec3, 32> crown_of(const StreetTree& tree, double metres_per_unit) {
  std::array<Vec3, 32> corners;
  const double radius = tree.crown_radius_m / metres_per_unit;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double degrees = 360.0 * static_cast<double>(i) / static_cast<double>(corners.size());
    corners[i] = {tree.position.x + radius * cos_degrees(degrees), tree.position.y + radius * cos_degrees(degrees - 90),
                  tree.position.z};
  }
  return corners;
}

}  // namespace ilot
