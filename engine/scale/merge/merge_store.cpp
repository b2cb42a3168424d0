// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge/merge_store.h"

#include <algorithm>
#include <string>

#include "engine/error.h"
#include "engine/labels/row_labels.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/resident.h"
#include "engine/products/planes/make_planes.h"
#include "engine/products/roofs/product.h"
#include "engine/products/streets/make_streets.h"
#include "engine/run/memory_budget.h"
#include "engine/run/products.h"
#include "engine/run/run_context.h"
#include "engine/scale/label_store.h"
#include "engine/scale/merge/merge_roof_labels.h"
#include "engine/scale/merge/merge_roofs.h"
#include "engine/scale/parts/cell_store.h"
#include "engine/scale/parts/part_place.h"
#include "engine/scale/task_inputs.h"
#include "engine/store/flushed.h"
#include "kernels/core/parallel.h"

namespace ilot {

namespace fs = std::filesystem;

void merge_store(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                 const fs::path& folder, const fs::path& staging, Progress& progress, RunRecord& record) {
  RunOptions run;
  run.memory_bytes = options.memory_bytes;
  run.settings = plan.settings;
  run.products = plan.products;
  run.clouds = false;
  const RunInputs inputs = frozen_inputs(plan);  // none is opened: the parts have all that is needed
  set_memory_limit(memory_to_fill(run));
  const KeptColumns kept;
  fs::remove_all(folder);
  fs::create_directories(folder);
  open_flushed(folder);
  const std::uint64_t block_points = affordable_block_points(run, thread_count());
  PassContext context = pass_context(run, inputs, block_points, progress);
  context.rounding = plan.rounding;
  context.corner = plan.corner;
  progress.begin_stage("merge", plan.points);
  const Store store = store_of_parts(parts_of(plan, options.plan), areas, plan, block_points, folder, context);
  progress.end_stage();
  if (store.points() == 0) throw Error(options.plan.string() + ": the parts have no points");
  const StreetTraining training;
  ProductRun work{.store = store,
                  .inputs = inputs,
                  .settings = plan.settings,
                  .context = context,
                  .training = &training,
                  .asked = [&](const char* product) { return std::ranges::count(plan.products, product) > 0; },
                  .folder = staging,
                  .progress = progress,
                  .record = record};
  const std::vector<const Product*> products = products_to_make(plan.products);
  const auto make = [&](const Product& product) {
    if (&product != &roofs_product()) return product.make(work);
    const MergedRoofs roofs = merge_roofs(options.plan, plan, {chosen_of_roofs(plan, store, context), work.openings},
                                          folder / kBuildingsOfParts, areas, staging, progress, record);
    merge_roof_labels(store, folder / kLabelsOfParts, areas, roofs, context);
  };
  make_all(products, work, make);
  std::optional<LabelledPlanes> planes;
  if (options.labels && work.planes) planes = {work.planes->planes, work.planes->curved.has_value()};
  const std::vector<ProductLabels> labels = labels_of(products, work);
  record.points.labelled = count_labelled(store, labels, context);
  record.points.unlabelled = record.points.read - record.points.rejected_total() - record.points.labelled;
  record.blocks = store.blocks().size();
  if (options.labels)
    prepare_labels(store, labels, planes, context);
  else
    fs::remove_all(folder);
}

}  // namespace ilot
