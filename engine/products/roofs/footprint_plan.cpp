// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/footprint_plan.h"

#include <algorithm>

#include "engine/deliverables/layers/footprints.h"

namespace ilot {
namespace {

// Choice: an overlap of 10 cm along a wall of 10 m.
constexpr double kSharedArea = 1;  // m2; smaller overlaps come from imprecise drawing

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
    if (other != site && shared_area(sites[site].outline, sites[other].outline) >= kSharedArea) others.push_back(other);
  return others;
}

}  // namespace ilot
