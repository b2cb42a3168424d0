// SPDX-License-Identifier: Apache-2.0
#include "engine/run/footprint_plan.h"

#include <algorithm>

#include "engine/deliverables/footprints.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr double kSharedArea = 1;  // m2; less is how outlines were drawn

}  // namespace

std::vector<PlannedSite> plan_footprints(const std::filesystem::path& path, const Crs& crs, Progress& progress,
                                         RunRecord& record) {
  const FootprintFile file = read_footprints(path, crs);
  std::vector<PlannedSite> sites = plan_sites(file.footprints, crs.metres_per_unit);
  FootprintsRecord& told = record.footprints.emplace();
  told.path = path.string();
  told.footprints = file.footprints.size();
  told.id_attribute = file.id_attribute;
  told.transformed = file.transformed;
  for (const PlannedSite& site : sites) {
    told.mended += !site.repair.empty();
    told.without_outline += site.outline.polygon.empty();
  }
  for (const std::string& warning : file.warnings) {
    progress.warn(warning);
    record.warnings.push_back(warning);
  }
  return sites;
}

std::vector<std::vector<std::uint32_t>> overlaps(std::span<const PlannedSite> sites, const OutlineMap& map) {
  std::vector<std::vector<std::uint32_t>> all(sites.size());
  parallel_for(sites.size(), [&](std::size_t i) {
    if (sites[i].outline.polygon.empty()) return;
    for (const std::uint32_t other : map.near(sites[i].outline.box))
      if (other != i && shared_area(sites[i].outline, sites[other].outline) >= kSharedArea) all[i].push_back(other);
  });
  return all;
}

}  // namespace ilot
