// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/run_task.h"

#include <algorithm>
#include <new>

#include "engine/error.h"
#include "engine/formats/remote_file.h"
#include "engine/pass/index.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/products/roofs/roof_roles.h"
#include "engine/report/counted.h"
#include "engine/run/memory_budget.h"
#include "engine/run/peak_warning.h"
#include "engine/scale/chunk_boxes.h"
#include "engine/scale/label_task.h"
#include "engine/scale/parts/building_part.h"
#include "engine/scale/parts/cell_part.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/parts/part_place.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_products.h"
#include "engine/scale/records.h"
#include "engine/scale/task_inputs.h"
#include "engine/scale/work_folder.h"
#include "engine/store/flushed.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

Store index_of_area(const RunOptions& options, const RunInputs& inputs, const Plan& plan, const PlanArea& area,
                    const fs::path& chunks, const fs::path& folder, const PassContext& context) {
  if (inputs.readers.empty() || area.read.is_empty()) return {folder, plan.lattice.unit, {}};
  IndexParams p;
  p.unit = plan.lattice.unit;
  p.multiple = plan.lattice.multiple;
  for (const int code : options.settings.classes.noise) p.filter.noise.set(static_cast<std::size_t>(code));
  p.filter.keep = area.read;
  for (const std::uint32_t i : area.inputs)
    p.rows.push_back(rows_that_meet(read_chunks(chunks / std::to_string(i + 1)), area.read));
  p.finest_step = options.settings.index.finest_step;
  p.keep_strays = options.settings.index.keep_strays;
  p.strays = Strays(plan.stray_bits, plan.strays);
  if (makes_roofs(plan) || carries_class_codes(plan)) p.classes = ClassColumns::written;
  p.block_points = p.run_points = affordable_block_points(options, thread_count());
  IndexResult index = build_index(inputs.readers, p, folder, context);
  if (!(index.lattice == plan.lattice))
    throw Error("the inputs of this area need another lattice than the plan has; make the plan again");
  return std::move(index.store);
}

// Makes the part of the area, and returns what its end says.
PartSummary make_part(const TaskOptions& task, const Plan& plan, const PlanArea& area, const WorkFolder& work,
                      const fs::path& part, Progress& progress) {
  const RunOptions options = run_options(task, plan, area.inputs);
  LocalSites local;
  if (makes_roofs(plan)) local = read_sites(task.plan / kSitesFolder / std::to_string(task.number), area);
  const RunInputs inputs = open_needed(options, plan, area.inputs);
  set_memory_limit(memory_to_fill(options));
  const KeptColumns kept;
  const fs::path folder = work.path() / "store";
  fs::create_directories(folder);
  open_flushed(folder);
  const PassContext context = frozen_context(options, inputs, plan, progress);
  progress.begin_stage("index", inputs.points);
  const Store store = index_of_area(options, inputs, plan, area, task.plan / kChunksFolder, folder, context);
  progress.end_stage();
  RecordFileWriter file(part, part_head(area.key));
  PartSummary summary;
  if (makes_roofs(plan)) {
    if (store.points() > 0) make_roof_roles(store, plan.settings, context, progress, plan.roofs.by_shape);
    write_buildings(store, local, plan, context, progress, file, summary);
  }
  if (carries_points(plan)) summary.cells = write_cells(store, inputs, plan, area, context, progress, file);
  file.add(summary_record(summary));
  file.finish();
  return summary;
}

int exit_code(const PartSummary& summary) {
  return static_cast<int>(summary.without_model == 0 ? ExitCode::ok : ExitCode::incomplete);
}

int work_on_area(const TaskOptions& options, const Plan& plan, Progress& progress) {
  const PlanArea& area = plan.areas[options.number - 1];
  const fs::path part = parts_of(plan, options.plan) / std::to_string(options.number);
  PartSummary summary;
  const PartState state = part_state(part, area.key, summary);
  if (state == PartState::whole) {
    progress.note(part.string() + ": is done, nothing is left to do");
    return exit_code(summary);
  }
  if (state != PartState::missing)
    progress.note(part.string() + (state == PartState::stale ? ": belongs to another plan" : ": is damaged") +
                  " and is made again");
  check_inputs(plan, area.inputs);
  const std::string beginning = "." + std::to_string(options.number) + "-";
  std::optional<WorkFolder> beside, elsewhere;
  if (!options.work.empty()) elsewhere.emplace(options.work, "ilot-task" + beginning);
  if (!elsewhere || !is_remote(part)) beside.emplace(options.plan / kPartsFolder, beginning);
  const fs::path made = (beside ? *beside : *elsewhere).path() / "part";
  summary = make_part(options, plan, area, elsewhere ? *elsewhere : *beside, made, progress);
  check_inputs(plan, area.inputs);  // a change while the task read
  publish_part(made, part);         // a twin's file has the same bytes
  warn_of_peak(options.memory_bytes, progress);
  progress.run_done(part.string() + ": " + (makes_roofs(plan) ? counted(area.sites, "building") : "") +
                    (makes_roofs(plan) && carries_points(plan) ? ", " : "") +
                    (carries_points(plan) ? counted(summary.cells, "cell") : "") +
                    (summary.without_model == 0 ? "" : ", " + grouped(summary.without_model) + " without a model"));
  return exit_code(summary);
}

std::vector<std::uint32_t> inputs_of(const TaskOptions& options, const Plan& plan) {
  if (options.label) return {static_cast<std::uint32_t>(options.number - 1)};
  return plan.areas[options.number - 1].inputs;
}

// Where the inputs are as the plan says, their points were read once already: what failed was the machine.
[[noreturn]] void throw_after(const std::string& fault, const Plan& plan, std::span<const std::uint32_t> inputs) {
  check_inputs(plan, inputs);
  throw Error(fault + " (exit 75: try the task again)", ExitCode::try_again);
}

int work_on(const TaskOptions& options, const Plan& plan, Progress& progress) {
  if (!options.label) return work_on_area(options, plan, progress);
  label_input(options, plan, progress);
  warn_of_peak(options.memory_bytes, progress);
  return 0;
}

void check_number(const TaskOptions& options, const Plan& plan) {
  const std::size_t most = options.label ? plan.inputs.size() : plan.areas.size();
  if (options.number >= 1 && options.number <= most) return;
  throw Error("task " + std::string(options.label ? "label " : "") + std::to_string(options.number) +
                  ": the plan has " + (options.label ? "inputs" : "areas") + " 1 to " + std::to_string(most),
              ExitCode::usage);
}

}  // namespace

int run_task(const TaskOptions& options, Progress& progress) {
  const Plan plan = read_plan(options.plan);
  check_number(options, plan);
  progress.run_start("ilot task");
  const int wanted = options.threads > 0 ? options.threads : hardware_threads();
  const std::vector<std::uint32_t> inputs = inputs_of(options, plan);
  int code = 0;
  try {
    with_threads(affordable_threads(options.memory_bytes, wanted), [&] { code = work_on(options, plan, progress); });
  } catch (const Error& fault) {
    if (fault.code() == ExitCode::usage) throw;
    throw_after(fault.what(), plan, inputs);
  } catch (const fs::filesystem_error& fault) {
    throw_after(fault.what(), plan, inputs);
  } catch (const std::bad_alloc&) {
    throw_after("out of memory", plan, inputs);
  }
  return code;
}

}  // namespace ilot
