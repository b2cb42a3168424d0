// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/storeys.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ilot {
namespace {

// Choice: eaves reach up to a metre over the wall; what is farther away is a neighbour across an alley.
constexpr double kWallReach = 1;  // metres between a wall and the edge of the outline above it
// Choice: as for party walls; outlines of few sides follow walls so closely.
constexpr double kSameWay = 0.985;  // cosine of 10 degrees
// Choice: the middles of doors and windows of one storey, the low and the high ones.
constexpr double kRowHeight = 1;  // metres
// Choice: a room to stand in with its floor is higher than this.
constexpr double kLeastStorey = 2;  // metres

// Counts rows, that with the most openings first. Each takes the openings that are less than a storey from its middle.
std::int64_t storeys_at(std::vector<double> heights) {
  std::ranges::sort(heights);
  std::int64_t storeys = 0;
  for (; !heights.empty(); ++storeys) {
    std::size_t first = 0, most = 0;
    for (std::size_t i = 0, end = 0; i < heights.size(); ++i) {
      while (end < heights.size() && heights[end] - heights[i] <= kRowHeight) ++end;
      if (end - i > most) first = i, most = end - i;
    }
    const double middle = heights[first + most / 2];
    std::erase_if(heights, [&](double z) { return std::abs(z - middle) < kLeastStorey; });
  }
  return storeys;
}

}  // namespace

StoreyCounter::StoreyCounter(std::span<const FacadeOpening> openings, double metres_per_unit) {
  for (const FacadeOpening& o : openings)
    openings_.push_back(
        {o.middle.x * metres_per_unit, o.middle.y * metres_per_unit, o.middle.z * metres_per_unit, o.out_x, o.out_y});
  const auto key = [](const Opening& o) { return std::tuple(o.x, o.y, o.z, o.out_x, o.out_y); };
  std::ranges::sort(openings_, {}, key);
}

std::optional<std::int64_t> StoreyCounter::storeys(const PlacedOutline& outline) const {
  const GridBox& box = outline.box;
  const double low = static_cast<double>(box.min_x) * kGridMetres - kWallReach;
  const double high = static_cast<double>(box.max_x) * kGridMetres + kWallReach;
  const double x0 = static_cast<double>(outline.x) * kGridMetres, y0 = static_cast<double>(outline.y) * kGridMetres;
  // An edge has the building on its left, so that the outside is on its right.
  const auto faces = [&](const Opening& o, Point2 from, Point2 to) {
    const double ax = x0 + from.x * kGridMetres, ay = y0 + from.y * kGridMetres;
    const double dx = (to.x - from.x) * kGridMetres, dy = (to.y - from.y) * kGridMetres;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0) || o.out_x * dy - o.out_y * dx < kSameWay * length) return false;
    const double along = ((o.x - ax) * dx + (o.y - ay) * dy) / length;
    const double away = ((o.x - ax) * dy - (o.y - ay) * dx) / length;
    return along >= 0 && along <= length && std::abs(away) <= kWallReach;
  };
  const auto in_a_wall = [&](const Opening& o) {
    for (const auto& ring : outline.polygon)
      for (std::size_t i = 0; i < ring.size(); ++i)
        if (faces(o, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1])) return true;
    return false;
  };
  std::vector<double> heights;
  auto opening = std::ranges::lower_bound(openings_, low, {}, &Opening::x);
  for (; opening != openings_.end() && opening->x <= high; ++opening)
    if (in_a_wall(*opening)) heights.push_back(opening->z);
  if (heights.empty()) return std::nullopt;
  return storeys_at(std::move(heights));
}

void StoreyCounter::add_to(BuildingAttributes& attributes, const PlacedOutline& outline) const {
  if (const auto seen = storeys(outline)) attributes.emplace_back("storeys", *seen);
}

}  // namespace ilot
