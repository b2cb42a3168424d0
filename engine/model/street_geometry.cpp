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

}  // namespace ilot
