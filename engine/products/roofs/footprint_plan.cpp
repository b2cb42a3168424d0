// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/footprint_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/deliverables/layers/footprints.h"

namespace ilot {
namespace {

// Choice: an overlap of 10 cm along a wall of 10 m.
constexpr double kSharedArea = 1;  // m2; smaller overlaps come from imprecise drawing
// Derived: far above the rounding of doubles.
constexpr double kSurelyLess = 0.99;

// How far, in grid steps, the second polygon reaches beyond the best edge of the first one that has all of the first on
// one side. Infinite where there is no such edge; 0 for neighbours with a common wall.
double reach_into(const SitePolygon& polygon, const SitePolygon& other) {
  const auto& ring = polygon[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const auto left = [&](Point2 p) { return orient2d(a, b, p); };
    if (std::ranges::any_of(ring, [&](Point2 p) { return left(p) < 0; })) continue;
    const auto farthest = std::ranges::max(other[0], {}, left);
    least = std::min(least, std::max(0.0, static_cast<double>(left(farthest))) /
                                std::sqrt(static_cast<double>(squared_distance(a, b))));
  }
  return least;
}

// A bound of the area in square metres that two outlines share, which most neighbours keep far below what counts. Outer
// rings turn left.
double most_shared(const PlacedOutline& a, const PlacedOutline& b) {
  const GridBox common{std::max(a.box.min_x, b.box.min_x), std::max(a.box.min_y, b.box.min_y),
                       std::min(a.box.max_x, b.box.max_x), std::min(a.box.max_y, b.box.max_y)};
  const auto width = static_cast<double>(common.max_x - common.min_x);
  const auto height = static_cast<double>(common.max_y - common.min_y);
  const SitePolygon other = seen_from(b, a.x, a.y);
  const double strip = std::min(reach_into(a.polygon, other), reach_into(other, a.polygon));
  return kGridMetres * kGridMetres * std::min(width * height, strip * std::sqrt(width * width + height * height));
}

bool overlap(const PlacedOutline& a, const PlacedOutline& b) {
  return most_shared(a, b) >= kSurelyLess * kSharedArea && shared_area(a, b) >= kSharedArea;
}

}  // namespace

std::vector<PlannedSite> plan_footprints(const std::filesystem::path& path, const std::string& id_field, const Crs& crs,
                                         Progress& progress, RunRecord& record) {
  const FootprintFile file = read_footprints(path, crs, id_field);
  std::vector<PlannedSite> sites = plan_sites(file.footprints, crs.metres_per_unit);
  FootprintsRecord& summary = record.footprints.emplace();
  summary.path = path.string();
  summary.footprints = file.footprints.size();
  summary.id_attribute = file.id_attribute;
  summary.transformed = file.transformed;
  for (const PlannedSite& site : sites) {
    summary.mended += !site.repair.empty();
    summary.without_outline += site.outline.polygon.empty();
  }
  for (const std::string& warning : file.warnings) {
    progress.warn(warning);
    record.warnings.push_back(warning);
  }
  return sites;
}

std::vector<std::uint32_t> overlapping(std::span<const PlannedSite> sites, const OutlineMap& map, std::size_t site) {
  std::vector<std::uint32_t> others;
  if (sites[site].outline.polygon.empty()) return others;
  for (const std::uint32_t other : map.near(sites[site].outline.box))
    if (other != site && overlap(sites[site].outline, sites[other].outline)) others.push_back(other);
  return others;
}

}  // namespace ilot
