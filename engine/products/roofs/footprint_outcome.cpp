// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/footprint_outcome.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/report/counted.h"

namespace ilot {
namespace {

GridBox box_of(std::span<const PlannedSite> sites) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  GridBox all{kFar, kFar, -kFar, -kFar};
  for (const PlannedSite& site : sites) {
    if (site.outline.polygon.empty()) continue;
    const GridBox& box = site.outline.box;
    all = {std::min(all.min_x, box.min_x), std::min(all.min_y, box.min_y), std::max(all.max_x, box.max_x),
           std::max(all.max_y, box.max_y)};
  }
  return all;
}

// Returns for example "x 84,871 to 85,063, y 447,388 to 447,616", in units of the CRS.
std::string place_text(const GridBox& box, double metres_per_unit) {
  const auto text = [&](std::int64_t mm) {
    const std::int64_t whole = std::llround(static_cast<double>(mm) * kGridMetres / metres_per_unit);
    return (whole < 0 ? "-" : "") + grouped(static_cast<std::uint64_t>(std::abs(whole)));
  };
  return "x " + text(box.min_x) + " to " + text(box.max_x) + ", y " + text(box.min_y) + " to " + text(box.max_y);
}

}  // namespace

GridBox extent_of_points(const IndexBox& points, double step_metres) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  if (points.is_empty()) return {kFar, kFar, -kFar, -kFar};
  const double mm = step_metres * 1000;
  const auto low = [&](std::int64_t v) { return static_cast<std::int64_t>(std::floor(static_cast<double>(v) * mm)); };
  const auto high = [&](std::int64_t v) { return static_cast<std::int64_t>(std::ceil(static_cast<double>(v) * mm)); };
  return {low(points.min.x), low(points.min.y), high(points.max.x), high(points.max.y)};
}

SiteNames names_of(std::span<const PlannedSite> sites, const GridBox& extent) {
  SiteNames names;
  names.sites = sites.size();
  for (const PlannedSite& site : sites) {
    names.all.insert(site.id);
    if (!site.outline.polygon.empty() && !site.outline.box.meets(extent)) names.beyond.insert(site.id);
  }
  return names;
}

void resolve_skipped_footprints(const SiteNames& names, Progress& progress, RunRecord& record) {
  if (!record.footprints) return;
  const auto is_beyond = [&](const SkippedRecord& s) { return s.what == "unit" && names.beyond.contains(s.where); };
  std::map<std::string, std::vector<std::string>> within;  // the cloud's extent, by reason
  std::vector<std::string>& outside = record.footprints->outside;
  for (const SkippedRecord& s : record.skipped) {
    if (is_beyond(s))
      outside.push_back(s.where);
    else if (s.what == "unit" && names.all.contains(s.where))
      within[s.reason].push_back(s.where);
  }
  for (const auto& [reason, ids] : within)
    progress.units_skipped(ids, ids.size() == 1 ? "footprint is" : "footprints are", reason);
  std::erase_if(record.skipped, is_beyond);
  if (!outside.empty())
    progress.note(grouped(outside.size()) + " of " + grouped(names.sites) +
                  " footprints are outside of the cloud's extent: " + first_names(outside));
}

std::string why_no_building(std::span<const PlannedSite> sites, bool given, bool area, const GridBox& extent,
                            const CrsRecord& crs) {
  if (!given)
    return "there is no building: no cluster of points above the ground is large enough; see classes.building, "
           "roofs.trust_classes and roofs.cluster_points";
  const auto with = std::count_if(sites.begin(), sites.end(), [](const auto& s) { return !s.outline.polygon.empty(); });
  if (with == 0)
    return "none of " + grouped(sites.size()) + " footprints gives an outline" +
           (sites.empty() ? "" : ": of " + sites.front().id + ", " + sites.front().reason);
  if (area) return "none of " + grouped(sites.size()) + " footprints is inside of the area (--bounds, --within)";
  const std::string where = crs.name == "none" ? "" : " (both in " + crs.name + ")";
  return "none of " + grouped(sites.size()) + " footprints is where the clouds are: the footprints are at " +
         place_text(box_of(sites), crs.metres_per_unit) + ", the clouds at " + place_text(extent, crs.metres_per_unit) +
         where;
}

}  // namespace ilot
