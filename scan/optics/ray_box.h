// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <limits>

#include "kernels/geometry/box3.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// Returns where the ray enters the box: 0 when it starts inside, infinity when it misses the box.
inline double entry(const Ray& ray, const Box3<Vec3>& box) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  const auto clip = [&](double origin, double direction, double low, double high) {
    if (direction == 0) {
      if (origin < low || origin > high) leave = -1;
      return;
    }
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(ray.origin.x, ray.direction.x, box.min.x, box.max.x);
  clip(ray.origin.y, ray.direction.y, box.min.y, box.max.y);
  clip(ray.origin.z, ray.direction.z, box.min.z, box.max.z);
  return enter > leave ? std::numeric_limits<double>::infinity() : enter;
}

}  // namespace ilot::scan
