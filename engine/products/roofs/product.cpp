// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/product.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "engine/columns/point_roles.h"
#include "engine/products/product_edits.h"
#include "engine/products/roofs/cluster_plan.h"
#include "engine/products/roofs/edits/class_edits.h"
#include "engine/products/roofs/footprint_outcome.h"
#include "engine/products/roofs/make_roofs.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/products/roofs/roof_roles.h"
#include "engine/products/roofs/terrain_model.h"
#include "engine/report/counted.h"

namespace ilot {
namespace {

// Derived: a hundred last returns on a small house.
constexpr double kLeastDensity = 1;  // last returns per square metre: a hundred on a small house
// Choice: airborne scans have up to some hundred, fronts from the ground thousands; drones can have as many.
constexpr double kGroundDensity = 1000;
constexpr std::size_t kBuilding = 6, kBuildingParts = 67;  // class codes of the LAS standard

Suitability suits(const CloudInfo& info, const CloudMeasure& measure) {
  const double returns = measure.last_return_density;
  const std::string density =
      returns < kGroundDensity ? fmt::format("{:.3g} last returns/m2", returns)
                               : fmt::format("{:.0f} last returns/m2 seen from above, as upright walls have", returns);
  if (!info.stations.empty()) return {false, "scanned from stations on the ground, which see few roofs"};
  if (measure.last_return_density < kLeastDensity) return {false, density + ", 1 at least"};
  if (measure.classes[kBuilding] + measure.classes[kBuildingParts] > 0)
    return {true, density + ", class 6 says what buildings are"};
  if (returns >= kGroundDensity) return {true, density + ": only where roofs were scanned too, as from a drone"};
  return {true, density + ", no point of class 6: buildings are found by shape or from --footprints"};
}

std::string summary(const RunRecord& record) {
  if (!record.roofs) return "";
  const std::uint64_t all = record.roofs->buildings, without = record.roofs->footprint_only;
  return without == 0 ? counted(all, "building")
                      : grouped(all - without) + " of " + counted(all, "building") + " with a model";
}

// Sets the classes that a person gave to points, after all others are known.
void edit_classes(ProductRun& run) {
  const ClassEdits edits(run.inputs.edits, run.store.unit());
  if (edits.size() == 0) return;
  const std::vector<std::uint64_t> points = edit_roles(run.store, edits, run.context);
  EditTally tally(run.progress, run.record);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (points[i] > 0)
      tally.made();
    else if (run.context.wanted)
      tally.outside();
    else
      tally.without_partner(edits[i], "no point of the cloud lies in the area of this edit");
  }
}

void make_roles(ProductRun& run) {
  const std::optional<RoleCounts> counted = make_roof_roles(run.store, run.settings, run.context, run.progress);
  edit_classes(run);
  if (!counted) return;
  run.record.chosen.push_back({"roofs.trust_classes", std::string("false"), found_by_shape(*counted)});
}

// One line for all outlines of clusters that have no model, the most frequent reason first.
void note_clusters_without_model(Progress& progress, const ClustersRecord& clusters) {
  std::vector<std::pair<std::string, std::uint64_t>> reasons(clusters.without_model.begin(),
                                                             clusters.without_model.end());
  if (reasons.empty()) return;
  std::ranges::stable_sort(reasons, std::greater{}, [](const auto& r) { return r.second; });
  std::uint64_t all = 0;
  std::string text;
  for (const auto& [reason, count] : reasons) {
    all += count;
    text += (text.empty() ? "" : "; ") + reason + ": " + grouped(count);
  }
  progress.note(counted(all, "outline that was found in the cloud has", "outlines that were found in the cloud have") +
                " no model (" + text + ")");
}

void make_terrain(ProductRun& run) {
  run.progress.begin_stage("terrain", run.store.points(), {run.store.points(), "points"});
  const TerrainModel model = write_terrain_model(run.store, run.folder / "roofs", run.inputs.crs, run.context);
  run.progress.end_stage();
  if (model.pixel_m > 0)
    run.record.chosen.push_back(
        {"roofs.dtm", fmt::format("{} m", model.pixel_m),
         fmt::format("side of its pixels; {:.3g} points of the ground per square metre", model.density_m2)});
  else
    run.progress.warn("roofs.dtm: no point of the ground was found, so there is no terrain model");
}

void make(ProductRun& run) {
  make_roles(run);
  const bool given = run.footprints != nullptr;
  std::vector<PlannedSite> clusters;
  if (!given) clusters = plan_clusters(run.store, run.settings.roofs, run.context, run.progress, run.record);
  const std::vector<PlannedSite>& sites = given ? *run.footprints : clusters;
  make_roofs(run.store, sites, run.openings, run.settings, run.inputs, run.context,
             {run.folder / "roofs", run.progress, run.record});
  if (run.settings.roofs.dtm) make_terrain(run);
  const GridBox extent = extent_of_points(run.store.box(), run.store.unit() * run.context.metres_per_unit);
  if (given) resolve_skipped_footprints(names_of(sites, extent), run.progress, run.record);
  if (!given) note_clusters_without_model(run.progress, *run.record.clusters);
  const std::uint64_t outside = given ? run.record.footprints->outside.size() : 0;
  if (run.record.roofs->buildings == outside)
    skip_product(run, roofs_product(),
                 why_no_building(given ? sites : std::vector<PlannedSite>{}, given, run.context.wanted != nullptr,
                                 extent, run.record.crs));
}

ProductLabels labels(ProductRun& run) {
  return roof_labels(run.planes != nullptr);
}

}  // namespace

const Product& roofs_product() {
  static const Product product{.name = "roofs",
                               .reads_classes = true,
                               .cost = {44, 8, 1.5},
                               .suitability = suits,
                               .make = make,
                               .labels = labels,
                               .summary = summary,
                               .main_file = "roofs/roofs.city.json"};
  return product;
}

}  // namespace ilot
