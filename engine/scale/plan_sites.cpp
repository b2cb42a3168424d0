// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_sites.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "engine/products/roofs/cluster_plan.h"
#include "engine/products/roofs/roof_roles.h"
#include "engine/report/sha256.h"
#include "engine/scale/plan_update.h"
#include "engine/scale/records.h"
#include "engine/scale/site_records.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// Clusters with the values that another plan measured, which a change of the points must not move.
std::vector<PlannedSite> clusters_as_before(const Plan& before, const Store& store, Settings settings,
                                            const PassContext& context, Progress& progress, RunRecord& record) {
  const std::vector<ChosenRecord> kept = keep_statistics(before, settings);
  std::vector<PlannedSite> sites = plan_clusters(store, settings.roofs, context, progress, record);
  for (const ChosenRecord& chosen : kept) {
    record.chosen.push_back(chosen);
    if (chosen.key != "roofs.cluster_distance") continue;
    const double now = suitable_cluster_distance(store, context), then = std::get<double>(chosen.value);
    if (now == then) continue;
    const std::string warning = fmt::format(
        "roofs.cluster_distance would be {:.3g} m for these points; {:.3g} m is kept from the other plan: make a full "
        "plan when all areas may run again",
        now, then);
    progress.warn(warning);
    record.warnings.push_back(warning);
  }
  return sites;
}

NumberedSite marked(std::size_t number, bool own, const PlannedSite& site, const SiteMarks& marks) {
  const bool outside = !site.outline.polygon.empty() && !site.outline.box.meets(marks.extent);
  return {number, own, outside, own && std::ranges::binary_search(marks.sampled, number), site};
}

}  // namespace

void find_roles(const std::array<std::uint64_t, 256>& classes, Plan& plan) {
  auto roles = point_roles(plan.settings.classes.building, plan.settings.classes.ground);
  if (!plan.settings.roofs.trust_classes) roles.fill(PointRole::unclassified);
  plan.roofs.by_shape = true;
  for (std::size_t code = 0; code < classes.size(); ++code)
    if (classes[code] > 0 && roles[code] == PointRole::building) plan.roofs.by_shape = false;
}

std::vector<PlannedSite> find_sites(const PlanOptions& options, const Store& store, const PassContext& context,
                                    Progress& progress, RunRecord& record, Plan& plan) {
  const Settings& settings = options.run.settings;
  plan.roofs.by_shape = make_roof_roles(store, settings, context, progress).has_value();
  std::vector<PlannedSite> sites =
      options.statistics.empty()
          ? plan_clusters(store, settings.roofs, context, progress, record)
          : clusters_as_before(read_plan(options.statistics), store, settings, context, progress, record);
  plan.roofs.clusters = record.clusters;
  return sites;
}

std::string write_sites(const fs::path& path, const AreaSites& cut, std::span<const PlannedSite> sites,
                        const SiteMarks& marks, PlanArea& area) {
  std::vector<std::size_t> all = cut.own;
  all.insert(all.end(), cut.neighbours.begin(), cut.neighbours.end());
  std::sort(all.begin(), all.end());
  RecordFileWriter file(path, {{"kind", "sites"}});
  Sha256 decides;
  for (const std::size_t i : all) {
    const NumberedSite site = marked(i, std::binary_search(cut.own.begin(), cut.own.end(), i), sites[i], marks);
    file.add(record_of(site));
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(without_number(site));
    decides.update(std::as_bytes(std::span(bytes)));
  }
  area.sites_sum = file.finish();
  return decides.hex();
}

}  // namespace ilot
