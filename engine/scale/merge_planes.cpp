// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge_planes.h"

#include <array>
#include <string>

#include "engine/error.h"
#include "engine/labels/row_labels.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/resident.h"
#include "engine/products/planes/make_planes.h"
#include "engine/products/planes/product.h"
#include "engine/run/memory_budget.h"
#include "engine/run/run_context.h"
#include "engine/scale/label_store.h"
#include "engine/scale/parts/cell_store.h"
#include "engine/store/flushed.h"
#include "kernels/core/parallel.h"

namespace ilot {

namespace fs = std::filesystem;

void merge_planes(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                  const fs::path& folder, const fs::path& staging, Progress& progress, RunRecord& record) {
  RunOptions run;
  run.memory_bytes = options.memory_bytes;
  run.settings = plan.settings;
  run.products = plan.products;
  run.clouds = false;
  RunInputs inputs;  // none is opened: the parts have all that is needed
  inputs.crs = plan.crs;
  inputs.points = plan.points;
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
  const Store store = store_of_parts(options.plan / kPartsFolder, areas, plan, block_points, folder, context);
  progress.end_stage();
  if (store.points() == 0) throw Error(options.plan.string() + ": the parts have no points");
  ProductRun work{.store = store,
                  .inputs = inputs,
                  .settings = plan.settings,
                  .context = context,
                  .asked = [](const char* product) { return std::string(product) == planes_product().name; },
                  .folder = staging,
                  .progress = progress,
                  .record = record};
  planes_product().make(work);
  const LabelledPlanes planes{options.labels ? work.planes->planes : std::vector<JoinedPlane>{},
                              work.planes->curved.has_value()};
  const std::array<ProductLabels, 1> labels{planes_product().labels(work)};
  record.points.labelled = count_labelled(store, labels, context);
  record.points.unlabelled = record.points.read - record.points.rejected_total() - record.points.labelled;
  record.blocks = store.blocks().size();
  if (options.labels)
    prepare_labels(store, labels, planes, context);
  else
    fs::remove_all(folder);
}

}  // namespace ilot
