// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/site_plan.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "engine/products/roofs/sites/outline_repair.h"

namespace ilot {
namespace {

// Derived: ten centimetres squared, a mistake of drawing.
constexpr double kLeastArea = 0.01;             // m2: a smaller outline is no building
constexpr std::int64_t kLargest = 100'000'000;  // millimetres: a larger outline is a mistake
constexpr double kMillimetresPerMetre = 1000;

bool is_number(const std::string& id) {
  return !id.empty() && id.size() < 19 && id.find_first_not_of("0123456789") == std::string::npos;
}

bool before(const std::string& a, const std::string& b) {
  if (!is_number(a) || !is_number(b)) return is_number(a) != is_number(b) ? is_number(a) : a < b;
  return std::make_tuple(std::stoull(a), a) < std::make_tuple(std::stoull(b), b);
}

PlacedOutline on_grid(const FootprintPolygon& polygon, double metres_per_unit) {
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> rings;
  const auto grid = [&](double v) { return std::llround(v * metres_per_unit * kMillimetresPerMetre); };
  for (const auto& ring : polygon) {
    auto& placed = rings.emplace_back();
    for (const auto& [x, y] : ring) placed.emplace_back(grid(x), grid(y));
  }
  return place_outline(rings);
}

PlacedOutline placed_again(const SitePolygon& polygon, const PlacedOutline& from) {
  std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> rings;
  for (const auto& ring : polygon) {
    auto& placed = rings.emplace_back();
    for (const Point2 p : ring) placed.emplace_back(from.x + p.x, from.y + p.y);
  }
  return place_outline(rings);
}

// The sites of one footprint. Their ids are still only that of the footprint.
std::vector<PlannedSite> sites_of(const Footprint& footprint, double metres_per_unit) {
  std::vector<PlannedSite> sites;
  std::string fault = footprint.fault;
  for (const FootprintPolygon& part : footprint.parts) {
    const PlacedOutline given = on_grid(part, metres_per_unit);
    if (given.box.max_x - given.box.min_x > kLargest || given.box.max_y - given.box.min_y > kLargest) {
      fault = "its outline spans more than 100 km";
      continue;
    }
    const RepairedOutline repaired = repair_outline(given.polygon, kLeastArea);
    if (repaired.polygons.empty()) fault = repaired.repair;
    for (const SitePolygon& polygon : repaired.polygons)
      sites.push_back({footprint.id, placed_again(polygon, given), "", repaired.repair, footprint.attributes});
  }
  if (sites.empty()) sites.push_back({footprint.id, {}, fault, "", footprint.attributes});
  return sites;
}

}  // namespace

std::vector<PlannedSite> plan_sites(std::span<const Footprint> footprints, double metres_per_unit) {
  std::set<std::string> used;
  for (const Footprint& f : footprints) used.insert(f.id);
  std::vector<PlannedSite> sites;
  for (const Footprint& footprint : footprints) {
    std::vector<PlannedSite> parts = sites_of(footprint, metres_per_unit);
    for (std::size_t n = 1, number = 2; n < parts.size(); ++n)
      while (!used.insert(parts[n].id = footprint.id + "-" + std::to_string(number++)).second) {
      }
    for (PlannedSite& part : parts) sites.push_back(std::move(part));
  }
  order_sites(sites);
  return sites;
}

void order_sites(std::vector<PlannedSite>& sites) {
  std::sort(sites.begin(), sites.end(), [](const PlannedSite& a, const PlannedSite& b) { return before(a.id, b.id); });
}

double shared_area(const PlacedOutline& a, const PlacedOutline& b) {
  if (!a.box.meets(b.box)) return 0;
  return shared_area(a.polygon, seen_from(b, a.x, a.y));
}

}  // namespace ilot
