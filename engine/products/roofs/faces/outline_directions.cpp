// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/outline_directions.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

// Choice: 3 degrees, the error of a line of ten steps.
constexpr double kSameDirection = 0.9986;  // cosine of 3 degrees

double length(FlatPoint d) {
  return std::sqrt(dot(d, d));
}

}  // namespace

void add_direction(FlatPoint along, double weight, std::vector<WeightedDirection>& directions) {
  const double size = length(along);
  if (!(size > 0)) return;
  along = {along.x / size, along.y / size};
  for (WeightedDirection& known : directions)
    if (std::abs(dot(known.along, along)) >= kSameDirection) {
      known.weight += weight;
      return;
    }
  directions.push_back({weight, along});
}

std::vector<WeightedDirection> outline_directions(const SitePolygon& outline) {
  std::vector<FlatPoint> sides;
  for (const auto& ring : outline)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 p = ring[i], q = ring[(i + 1) % ring.size()];
      sides.push_back({(q.x - p.x) / 1000.0, (q.y - p.y) / 1000.0});
    }
  std::stable_sort(sides.begin(), sides.end(), [](FlatPoint a, FlatPoint b) { return length(a) > length(b); });
  std::vector<WeightedDirection> directions;
  for (const FlatPoint side : sides) {
    add_direction(side, length(side), directions);
    add_direction({-side.y, side.x}, length(side) / 2, directions);
  }
  return directions;
}

}  // namespace ilot
