// SPDX-License-Identifier: Apache-2.0
// The planes of one roof, and which of its points lie on them.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/roofs/faces/roof_params.h"
#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

// z = x * gx + y * gy + c: a plane that a roof face can lie on. Metres from the site's anchor.
struct RoofPlane {
  double gx = 0, gy = 0, c = 0;
  double lowest = 0, highest = 0;  // lowest and highest z of the points that show it
  std::uint32_t points = 0;
  double at(double x, double y) const { return gx * x + gy * y + c; }
};

struct RoofPlanes {
  std::vector<RoofPlane> planes;
  std::vector<std::uint32_t> of_point;  // per point of the site: 0 = none, else 1 + index into planes
  std::vector<std::uint8_t> on_wall;    // per point: 1 = on a plane too steep for a roof
  double step = 0;                      // metres between points, seen from above
  double epsilon = 0;                   // metres; no labelled point lies farther from its plane
};

// Finds the planes by RANSAC [Marchand 2018, II.2.1.1] on normals that stay sharp beside edges [Boltcheva et al. 2019,
// 3.2.1]. Neighbours then decide the labels of points at borders, and planes that are equal within the noise are
// joined. Planes steeper than 75 degrees are walls. With superstructures, level tops that are too small for this method
// are added (level_tops.h). O(n log n).
RoofPlanes find_roof_planes(const RoofSite& site, const RoofModelParams& params);

}  // namespace ilot
