// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/face_limits.h"

#include <algorithm>
#include <cmath>

#include "kernels/geometry/flat_box.h"

namespace ilot {
namespace {

// Derived: a tip of this length and width would contain nine points or more, so one is seen.
constexpr double kBareTipSteps = 3;
// Choice: a storey; roofs of garages and terraces on a hillside lie as much below the ground of a site.
constexpr double kBelowGround = 3;  // metres

// Returns per cell whether it is too low somewhere on the plane of its label.
std::vector<std::uint8_t> fallen_cells(const RoofPlanes& planes, const Partition& cells,
                                       std::span<const std::uint32_t> label, const FaceLimits& limits) {
  std::vector<std::uint8_t> fallen(cells.regions, 0);
  for (const PartitionEdge& e : cells.edges)
    for (const std::uint32_t region : {e.left, e.right})
      if (region != kOutside)
        for (const std::uint32_t v : {e.from, e.to}) {
          const FlatPoint at{cells.vertices[v].x / 1000.0, cells.vertices[v].y / 1000.0};
          if (too_low(planes.planes[label[region - 1] - 1], at, limits) > 0) fallen[region - 1] = 1;
        }
  return fallen;
}

}  // namespace

double most_overshoot(const RoofPlane& plane, const FaceLimits& limits) {
  return std::max(limits.overshoot, kBareTipSteps * limits.step * std::sqrt(plane.gx * plane.gx + plane.gy * plane.gy));
}

double too_high(const RoofPlane& plane, FlatPoint at, const FaceLimits& limits) {
  return plane.at(at.x, at.y) - plane.highest - most_overshoot(plane, limits);
}

double too_low(const RoofPlane& plane, FlatPoint at, const FaceLimits& limits) {
  const double lowest = std::min(plane.lowest - most_overshoot(plane, limits), limits.ground - kBelowGround);
  return lowest - plane.at(at.x, at.y);
}

std::vector<std::uint32_t> falling_planes(const RoofPlanes& planes, const Partition& cells,
                                          std::span<const std::uint32_t> label, const FaceLimits& limits) {
  std::vector<std::uint32_t> falling;
  const std::vector<std::uint8_t> fallen = fallen_cells(planes, cells, label, limits);
  for (std::uint32_t r = 0; r < cells.regions; ++r)
    if (fallen[r] != 0) falling.push_back(label[r] - 1);
  std::sort(falling.begin(), falling.end());
  falling.erase(std::unique(falling.begin(), falling.end()), falling.end());
  return falling;
}

FlatEdge end_of_points(const RoofPlane& plane, const SitePolygon& outline) {
  FlatBox box = FlatBox::none();
  for (const auto& ring : outline)
    for (const Point2 p : ring) box.add({p.x / 1000.0, p.y / 1000.0});
  const FlatPoint middle = 0.5 * (box.min + box.max), slope{plane.gx, plane.gy};
  const double reach = norm(box.max - box.min), steepness = norm(slope);
  if (!(steepness > 0)) return {middle, middle};
  const FlatPoint along{-slope.y / steepness, slope.x / steepness};
  const FlatPoint at = middle + ((plane.lowest - plane.at(middle.x, middle.y)) / (steepness * steepness)) * slope;
  return {at - reach * along, at + reach * along};
}

void level_fallen(const Partition& cells, const FaceLimits& limits, RoofPlanes& planes,
                  std::vector<std::uint32_t>& label) {
  const std::vector<std::uint8_t> fallen = fallen_cells(planes, cells, label, limits);
  std::vector<std::uint32_t> level_of(planes.planes.size(), 0);  // label of the level plane
  for (std::uint32_t r = 0; r < cells.regions; ++r) {
    if (fallen[r] == 0) continue;
    std::uint32_t& level = level_of[label[r] - 1];
    if (level == 0) {
      RoofPlane plane;
      plane.c = plane.lowest = plane.highest = planes.planes[label[r] - 1].lowest;
      planes.planes.push_back(plane);
      level = static_cast<std::uint32_t>(planes.planes.size());
    }
    label[r] = level;
  }
}

}  // namespace ilot
