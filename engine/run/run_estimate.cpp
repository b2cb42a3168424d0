// SPDX-License-Identifier: Apache-2.0
#include "engine/run/run_estimate.h"

#include <algorithm>

#include "engine/run/products.h"

namespace ilot {
namespace {

// Cost of each point. The bytes of the index and of the products are measured and rounded up. They are the largest
// share for a district of 100,000 and 500,000 points and for a coloured facade of 200,000 (planes 92, roofs 86, facades
// 100, streets 44 and all four 172 bytes with the index). The seconds are the means of these runs on one thread.
constexpr ProductCost kIndex{44, 0, 0.5};
constexpr std::uint64_t kTables = 1u << 20;  // of a product of a cloud of few points: an empty GeoPackage has 100 KB
constexpr std::uint64_t kLabels = 44;        // of a point: all of its labels and its normal

// Measured: medians of 150 to 1,600 runs, most of them of small scanned clouds, microseconds per point of the cloud on
// two cores that other work shared. A single cloud is up to four times away from them, so that the time left settles
// only while a run goes on.
constexpr double kIndexCost = 1.2, kNormalsCost = 1.9, kPlanesCost = 21, kJoinCost = 3, kBoundariesCost = 5,
                 kFacadesCost = 5.3, kClustersCost = 5.7, kRoofsCost = 43, kStreetsCost = 2.3, kWriteCost = 2.8;

}  // namespace

RunEstimate estimate_run(const RunOptions& options, const RunInputs& inputs) {
  const auto points = static_cast<double>(inputs.points);
  RunEstimate estimate;
  const auto add = [&](const ProductCost& cost) {
    estimate.store_bytes += static_cast<std::uint64_t>(points * cost.store_bytes) + kTables;
    estimate.result_bytes += static_cast<std::uint64_t>(points * cost.result_bytes) + kTables;
    estimate.processor_seconds += points * cost.microseconds * 1e-6;
  };
  add(kIndex);
  for (const Product* product : products_to_make(options.products)) add(product->cost);
  if (!options.clouds) return estimate;
  for (const auto& reader : inputs.readers)
    estimate.result_bytes += reader->info().points * (reader->info().layout.record_length + kLabels);
  return estimate;
}

std::vector<PlannedStage> planned_stages(const RunOptions& options) {
  const auto asked = [&](const char* product) { return std::ranges::count(options.products, product) > 0; };
  std::vector<PlannedStage> stages{{"index", kIndexCost}};
  const auto add = [&](const PlannedStage& stage) { stages.push_back(stage); };
  if (asked("planes") || asked("facades"))
    for (const PlannedStage& s : {PlannedStage{"normals", kNormalsCost}, PlannedStage{"planes", kPlanesCost},
                                  PlannedStage{"join", kJoinCost}, PlannedStage{"boundaries", kBoundariesCost}})
      add(s);
  if (asked("facades")) add({"facades", kFacadesCost});
  if (asked("roofs") && options.footprints.empty()) add({"clusters", kClustersCost});
  if (asked("roofs")) add({"roofs", kRoofsCost});
  if (asked("streets")) add({"streets", kStreetsCost});
  if (options.clouds) add({"write", kWriteCost});
  return stages;
}

}  // namespace ilot
