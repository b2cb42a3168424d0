// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/building_part.h"

#include <utility>

#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/products/roofs/make_roofs.h"
#include "engine/scale/parts/roof_label_records.h"
#include "engine/scale/plan_products.h"
#include "engine/scale/site_records.h"

namespace ilot {
namespace {

// The labels that buildings gave, by place in the list of own sites.
using RunsOfSites = std::vector<std::vector<LabelRun>>;

void write_labels(const Store& store, RoofLabels& labels, const RunsOfSites& runs, const PassContext& context,
                  RecordFileWriter& part) {
  // Commits the file of labels; the columns that it writes too are not read.
  labels.write_columns(context, [&](std::uint32_t block) {
    return std::vector<PointLabel>(store.blocks()[block].points, PointLabel::none);
  });
  for (std::size_t site = 0; site < runs.size(); ++site) {
    stop_if_asked();
    for (const LabelRun& run : runs[site])
      part.add(record_of(stored_labels(store, static_cast<std::uint32_t>(site), run)));
  }
}

}  // namespace

LocalSites read_sites(const std::filesystem::path& path, const PlanArea& area) {
  LocalSites local;
  RecordFileReader file(path);
  try {
    while (const auto record = file.next()) {
      NumberedSite n = numbered_site(*record);
      if (n.sampled) local.sampled.push_back(local.own.size());
      if (n.own) local.own.push_back(local.sites.size());
      local.outside.push_back(n.outside);
      local.sites.push_back(std::move(n.site));
    }
  } catch (const nlohmann::json::exception&) {
    throw Error(path.string() + ": is damaged; make the plan again");
  }
  if (file.sum() != area.sites_sum) throw Error(path.string() + ": belongs to another plan; make the plan again");
  return local;
}

void write_buildings(const Store& store, const LocalSites& local, const Plan& plan, const PassContext& context,
                     Progress& progress, RecordFileWriter& part, PartSummary& summary) {
  const RoofSetup setup(store, local.sites, plan.settings, plan.crs, context);
  const bool carries = carries_roof_labels(plan);
  RoofLabels labels(store);
  RunsOfSites runs(local.own.size());
  summary.shifts = model_buildings(setup, local.own, local.sampled, context, progress, labels,
                                   [&](std::size_t n, SiteResult& result) {
                                     std::uint64_t labelled = 0;
                                     for (const LabelRun& run : result.labels) labelled += run.count;
                                     const bool asked = plan.roofs.footprints && !local.outside[local.own[n]];
                                     summary.without_model += asked && result.status == RoofStatus::footprint_only;
                                     if (carries) runs[n] = std::move(result.labels);
                                     part.add(record_of(BuiltSite{labelled, std::move(result)}));
                                   });
  if (carries) write_labels(store, labels, runs, context, part);
  progress.end_stage();
}

}  // namespace ilot
