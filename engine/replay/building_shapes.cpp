// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/building_shapes.h"

#include <algorithm>
#include <cmath>

#include "kernels/outlines/hull.h"

namespace ilot {

double floor_of(const BuildingReplay& building) {
  return building.steps.gathered.site.anchor.z * building.file.metres_per_unit;
}

std::vector<SeenPoint> seen_points(const BuildingReplay& building) {
  const GatheredSite& gathered = building.steps.gathered;
  const auto& places = gathered.places;
  const auto kind = gathered.by_class ? PointRole::building : PointRole::unclassified;
  std::vector<SeenPoint> seen;
  seen.reserve(building.points.size() + places.size());
  std::size_t next = 0;  // index among the points of the model
  const auto add_used = [&] {
    seen.push_back({gathered.site.points[next], kind, PointMembership::held, next});
    ++next;
  };
  for (const AroundPoint& p : building.points) {
    while (next < places.size() && places[next] < p.place) add_used();
    if (next < places.size() && places[next] == p.place)
      add_used();
    else
      seen.push_back({p.at - Vec3{0, 0, floor_of(building)}, p.role, p.membership, std::nullopt});
  }
  while (next < places.size()) add_used();
  return seen;
}

std::vector<SitePolygon> plane_hulls(const SiteSteps& steps) {
  const RoofPlanes& planes = steps.roof.planes;
  std::vector<std::vector<Point2>> points(planes.planes.size());
  for (std::size_t i = 0; i < planes.of_point.size(); ++i) {
    if (planes.of_point[i] == 0) continue;
    const Vec3& p = steps.roof.points[i];
    points[planes.of_point[i] - 1].push_back(
        {static_cast<std::int32_t>(std::lround(p.x * 1000)), static_cast<std::int32_t>(std::lround(p.y * 1000))});
  }
  std::vector<SitePolygon> hulls(points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    const std::vector<std::uint32_t> hull = convex_hull(points[n]);
    if (hull.size() < 3) continue;
    auto& ring = hulls[n].emplace_back();
    for (const std::uint32_t i : hull) ring.push_back(points[n][i]);
  }
  return hulls;
}

const char* name_of(PointRole role) {
  constexpr const char* kNames[] = {"unclassified", "building", "ground", "other"};
  return kNames[static_cast<int>(role)];
}

const char* name_of(PointMembership membership) {
  constexpr const char* kNames[] = {"none", "held", "beside", "ground"};
  return kNames[static_cast<int>(membership)];
}

}  // namespace ilot
