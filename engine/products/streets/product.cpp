// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/product.h"

#include "engine/products/streets/make_streets.h"
#include "engine/products/streets/street_labels.h"
#include "engine/report/counted.h"

namespace ilot {
namespace {

// Derived: a bollard of a square metre around it gets four points at this step.
constexpr double kMostStep = 0.5;  // metres: at this step a bollard or the roof of a car still gets a few points
constexpr const char* kNoObject = "nothing was found that stands on the ground";

Suitability suits(const CloudInfo&, const CloudMeasure& measure) {
  if (measure.sampling_step > kMostStep) return {false, step_text(measure) + ", 0.5 m at most"};
  return {true, step_text(measure)};
}

std::string summary(const RunRecord& record) {
  return record.streets ? counted(record.streets->objects, "object") : "";
}

void make(ProductRun& run) {
  make_streets(run.store, run.settings, *run.training, run.inputs.crs, run.context,
               {run.folder / "streets", run.progress, run.record}, run.inputs.edits);
  const StreetCounts& found = *run.record.streets;
  if (found.objects + found.trees + found.kerbs == 0) skip_product(run, streets_product(), kNoObject);
}

ProductLabels labels(ProductRun&) {
  return street_labels();
}

}  // namespace

const Product& streets_product() {
  static const Product product{.name = "streets",
                               .reads_classes = true,
                               .cost = {30, 8, 1.0},
                               .suitability = suits,
                               .make = make,
                               .labels = labels,
                               .summary = summary,
                               .main_file = "streets/objects.gpkg"};
  return product;
}

}  // namespace ilot
