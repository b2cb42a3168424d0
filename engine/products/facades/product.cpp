// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/product.h"

#include <fmt/format.h>

#include "engine/products/facades/facade_labels.h"
#include "engine/products/facades/make_facades.h"
#include "engine/report/counted.h"

namespace ilot {
namespace {

// Derived: ten points across a window with a width of one metre.
constexpr double kMostStep = 0.1;  // metres: ten points across a window with a width of one metre
constexpr const char* kNoFacade = "no upright plane is as large as a facade; see facades.least_width";

Suitability suits(const CloudInfo& info, const CloudMeasure& measure) {
  if (measure.sampling_step > kMostStep) return {false, step_text(measure) + ", 0.1 m at most"};
  if (info.stations.empty()) return {true, step_text(measure) + "; shadows need --stations"};
  return {true, step_text(measure) + ", " + counted(info.stations.size(), "station") + " known"};
}

std::string summary(const RunRecord& record) {
  return record.facades ? counted(record.facades->facades, "facade") : "";
}

void make(ProductRun& run) {
  run.openings = make_facades(run.store, *run.planes, run.settings, run.inputs, run.context, run.folder / "facades",
                              run.progress, run.record);
  if (run.record.facades->facades == 0) skip_product(run, facades_product(), kNoFacade);
}

ProductLabels labels(ProductRun&) {
  return facade_labels();
}

}  // namespace

const Product& facades_product() {
  static const Product product{.name = "facades",
                               .found_among_planes = true,
                               .reads_colours = true,
                               .reads_stations = true,
                               .cost = {16, 12, 1.5},
                               .suitability = suits,
                               .make = make,
                               .labels = labels,
                               .summary = summary,
                               .main_file = "facades/"};
  return product;
}

}  // namespace ilot
