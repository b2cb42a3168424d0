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
std::vector<PlannedSite> clusters_as_before(const Plan& before, const IndexResult& index, Settings settings,
                                            const PassContext& context, Progress& progress, RunRecord& record) {
  const std::vector<ChosenRecord> kept = keep_statistics(before, settings);
  std::vector<PlannedSite> sites = plan_clusters(index.store, settings.roofs, context, progress, record);
  for (const ChosenRecord& chosen : kept) {
    record.chosen.push_back(chosen);
    if (chosen.key != "roofs.cluster_distance") continue;
    const double now = suitable_cluster_distance(index.store, context), then = std::get<double>(chosen.value);
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

std::vector<PlannedSite> find_sites(const PlanOptions& options, const IndexResult& index,
                                    std::vector<PlannedSite> given, const PassContext& context, Progress& progress,
                                    RunRecord& record, Plan& plan) {
  const RunOptions& run = options.run;
  const Settings& settings = run.settings;
  if (!run.footprints.empty()) {
    auto roles = point_roles(settings.classes.building, settings.classes.ground);
    if (!settings.roofs.trust_classes) roles.fill(PointRole::unclassified);
    plan.roofs.by_shape = count_of(write_roles(index.store, roles, context), PointRole::building) == 0;
  } else {
    plan.roofs.by_shape = make_roof_roles(index.store, settings, context, progress).has_value();
    given = options.statistics.empty()
                ? plan_clusters(index.store, settings.roofs, context, progress, record)
                : clusters_as_before(read_plan(options.statistics), index, settings, context, progress, record);
    plan.roofs.clusters = record.clusters;
  }
  if (plan.roofs.by_shape)
    plan.chosen.push_back({"roofs.trust_classes", std::string("false"),
                           "no point of classes.building is used; ground and buildings are found by shape"});
  plan.chosen.insert(plan.chosen.end(), record.chosen.begin(), record.chosen.end());
  return given;
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
