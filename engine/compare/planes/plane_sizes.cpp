// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/plane_sizes.h"

#include <algorithm>
#include <unordered_set>

#include "kernels/geometry/ring.h"

namespace ilot {
double area_of(const TruePlane& plane) {
  double area = 0;
  for (const TruePolygon& polygon : plane.polygons) {
    area += norm(doubled_area(polygon.ring)) / 2;
    for (const Ring3& hole : polygon.holes) area -= norm(doubled_area(hole)) / 2;
  }
  return area;
}

PlaneSizes plane_sizes(std::span<const PlaneMatch> matches, std::span<const TruePlane> truth,
                       const std::function<bool(std::uint32_t)>& judged, double metres_per_unit) {
  PlaneSizes sizes{PlaneSizeClass{10, 0, 0}, {5, 0, 0}, {2, 0, 0}, {0, 0, 0}};
  std::unordered_set<std::uint32_t> matched;
  for (const PlaneMatch& match : matches) matched.insert(match.truth);
  for (const TruePlane& plane : truth) {
    if (plane.polygons.empty() || (judged && !judged(plane.id))) continue;
    const double area = area_of(plane) * metres_per_unit * metres_per_unit;
    const auto size = std::find_if(sizes.begin(), sizes.end(), [&](const auto& s) { return area >= s.from_m2; });
    if (size == sizes.end()) continue;
    ++size->truth;
    size->matched += matched.count(plane.id);
  }
  return sizes;
}

}  // namespace ilot
