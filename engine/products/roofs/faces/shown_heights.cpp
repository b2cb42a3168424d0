// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/shown_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

bool is_on(const RoofPlane& plane, Vec3 p, double epsilon) {
  const double lean = std::sqrt(1 + plane.gx * plane.gx + plane.gy * plane.gy);
  return std::abs(p.z - plane.at(p.x, p.y)) <= epsilon * lean;
}

// The points of each plane that may have neighbours on others, in order.
std::vector<std::vector<std::uint32_t>> members_at_borders(const RoofPlanes& planes, const RunNeighbours& runs) {
  const std::vector<std::uint8_t> quiet = uniform_runs(runs, planes.of_point);
  std::vector<std::vector<std::uint32_t>> members(planes.planes.size());
  for (std::uint32_t i = 0; i < planes.of_point.size(); ++i)
    if (planes.of_point[i] != 0 && quiet[i / RunNeighbours::kRun] == 0) members[planes.of_point[i] - 1].push_back(i);
  return members;
}

}  // namespace

void widen_heights(std::span<const Vec3> points, const NeighbourLists& neighbours, const RunNeighbours& runs,
                   RoofPlanes& planes) {
  std::vector<std::vector<std::uint32_t>> members = members_at_borders(planes, runs);
  std::vector<std::uint32_t> seen_by(points.size(), 0);  // the last plane from which a point was reached
  for (std::uint32_t label = 1; label <= planes.planes.size(); ++label) {
    RoofPlane& plane = planes.planes[label - 1];
    std::vector<std::uint32_t>& open = members[label - 1];
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      for (const std::uint32_t j : neighbours.of(i)) {
        if (j == kNoNeighbour) break;
        if (planes.of_point[j] == label || planes.on_wall[j] != 0 || seen_by[j] == label) continue;
        seen_by[j] = label;
        if (!is_on(plane, points[j], planes.epsilon)) continue;
        plane.lowest = std::min(plane.lowest, points[j].z);
        plane.highest = std::max(plane.highest, points[j].z);
        open.push_back(j);
      }
    }
  }
}

}  // namespace ilot
