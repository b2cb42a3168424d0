// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/product.h"

#include "engine/deliverables/tables/planes_csv.h"
#include "engine/deliverables/tables/planes_neighbours_csv.h"
#include "engine/deliverables/tables/shapes_csv.h"
#include "engine/products/planes/make_boundaries.h"
#include "engine/products/planes/make_planes.h"
#include "engine/products/planes/plane_labels.h"
#include "engine/report/counted.h"

namespace ilot {
namespace {

constexpr std::size_t kMostCorners = 1 << 19;  // corners of the outlines with which lines of sight are compared: 40 MB
constexpr const char* kNoPlane = "no plane has enough points; see planes.min_points and planes.epsilon";

Suitability suits(const CloudInfo&, const CloudMeasure& measure) {
  return {true, step_text(measure)};
}

std::string summary(const RunRecord& record) {
  std::string made;
  if (record.planes) made = counted(*record.planes, "plane");
  if (record.shapes) made += ", " + counted(*record.shapes, "curved shape");
  return made;
}

void write_tables(const ProductRun& run, const PlanesResult& planes) {
  write_planes_csv(run.folder / "planes.csv", planes.segments);
  PlanesNeighboursCsv neighbours(run.folder / "planes_neighbours.csv");
  each_plane_neighbours(run.store, planes, run.context.metres_per_unit,
                        [&](const PlaneNeighbours& pair) { neighbours.add(pair); });
  neighbours.finish();
  run.record.planes = planes.segments.size();
  if (!planes.curved) return;
  write_shapes_csv(run.folder / "shapes.csv", *planes.curved);
  run.record.shapes = planes.curved->size();
}

// Also runs for products that are found among planes.
void make(ProductRun& run) {
  const Settings settings = settings_of_planes(run.settings, run.asked("planes"));
  if (settings.planes.curved != run.settings.planes.curved)
    run.record.chosen.push_back(
        {"planes.curved", std::string("false"), "shapes are looked for with the product planes"});
  run.planes = std::make_shared<PlanesResult>(
      make_planes(run.store, run.inputs.readers, settings, run.context, run.progress, run.record));
  if (run.outlines_wanted) run.planes->outlines = LargestOutlines(kMostCorners);
  run.progress.begin_stage("boundaries", run.store.points());
  make_boundaries(run.store, *run.planes, run.settings, run.inputs, run.context, run.folder, run.record);
  write_tables(run, *run.planes);
  if (run.planes->segments.empty()) skip_product(run, planes_product(), kNoPlane);
}

// Of the planes only the data that labels need stays in memory.
ProductLabels labels(ProductRun& run) {
  PlanesResult& planes = *run.planes;
  return plane_labels({std::move(planes.final_id), std::move(planes.planes), run.settings.normals.write,
                       std::move(planes.final_shape)});
}

}  // namespace

Settings settings_of_planes(Settings settings, bool asked) {
  if (!asked && !settings.planes.curved) settings.planes.curved = false;
  return settings;
}

const Product& planes_product() {
  static const Product product{.name = "planes",
                               .reads_colours = true,
                               .cost = {48, 6, 2.5},
                               .suitability = suits,
                               .make = make,
                               .labels = labels,
                               .summary = summary,
                               .main_file = "planes.gpkg"};
  return product;
}

}  // namespace ilot
