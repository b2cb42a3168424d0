// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/make_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/columns/colours_pass.h"
#include "engine/error.h"
#include "engine/formats/file.h"
#include "engine/formats/remote_file.h"
#include "engine/pass/index.h"
#include "engine/pass/input_lattice.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/products/roofs/footprint_outcome.h"
#include "engine/products/roofs/footprint_plan.h"
#include "engine/products/roofs/roof_setup.h"
#include "engine/report/counted.h"
#include "engine/report/sha256.h"
#include "engine/run/check_settings.h"
#include "engine/run/folder_lock.h"
#include "engine/run/inputs/input_crs.h"
#include "engine/run/inputs/open_inputs.h"
#include "engine/run/memory_budget.h"
#include "engine/run/peak_warning.h"
#include "engine/run/products.h"
#include "engine/run/run_context.h"
#include "engine/run/run_request.h"
#include "engine/run/stray_warning.h"
#include "engine/run/suitability.h"
#include "engine/scale/chunk_boxes.h"
#include "engine/scale/cut_plan.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_products.h"
#include "engine/scale/plan_sites.h"
#include "engine/scale/plan_update.h"
#include "engine/scale/survey/survey_points.h"
#include "engine/store/flushed.h"
#include "engine/version.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

void check_folder(const PlanOptions& options) {
  const fs::path& folder = options.run.output;
  if (fs::exists(folder / kPlanFile))
    throw Error(folder.string() + ": contains a plan already; give another -o or remove it", ExitCode::usage);
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw Error(folder.string() + ": is not a folder", ExitCode::usage);
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != ".store" && name != kSitesFolder && name != kChunksFolder && name != kPartsFolder &&
        name != kLockFile && !name.starts_with(kPlanFile))
      throw Error(folder.string() + ": contains something else than an unfinished plan; give another -o",
                  ExitCode::usage);
  }
}

void check_parts(const PlanOptions& options) {
  if (options.parts.empty()) return;
  if (!is_writable_remote(options.parts))
    throw Error("--parts " + options.parts + ": must be of an object store, s3://, gs:// or az://", ExitCode::usage);
  if (!options.update.empty() && read_plan(options.update).parts == options.parts)
    throw Error("--parts " + options.parts + ": has the parts of the other plan; give another", ExitCode::usage);
}

// A task opens a part of the inputs and no footprints, and must come to the same CRS.
void check_crs(const RunOptions& options, const RunInputs& inputs, const RunRecord& record) {
  if (!options.crs.empty()) return;
  for (const InputRecord& input : record.inputs)
    if (input.crs != record.inputs[0].crs)
      throw Error(input.path + ": its CRS is " + input.crs + ", that of " + record.inputs[0].path + " is " +
                      record.inputs[0].crs + "; a plan needs one for all: give --crs EPSG:n",
                  ExitCode::usage);
  if (record.inputs[0].crs != crs_name(inputs.crs) && record.inputs[0].crs == "none")
    throw Error(record.inputs[0].path + ": has no CRS, the footprints have " + crs_name(inputs.crs) +
                    "; tasks do not read the footprints: give --crs EPSG:n",
                ExitCode::usage);
}

std::string sum_of_file(const fs::path& path) {
  const InputFile file(path);
  Sha256 sum;
  std::vector<std::byte> bytes(1u << 20);
  for (std::uint64_t at = 0; at < file.size();) {
    stop_if_asked();
    const std::size_t got = file.read_at(at, bytes);
    if (got == 0) throw Error(path.string() + ": ended while it was read");
    sum.update(std::span(bytes).first(got));
    at += got;
  }
  return sum.hex();
}

IndexParams params_of(const RunOptions& options, std::uint64_t block_points) {
  IndexParams p;
  for (const int code : options.settings.classes.noise) p.filter.noise.set(static_cast<std::size_t>(code));
  p.finest_step = options.settings.index.finest_step;
  p.keep_strays = options.settings.index.keep_strays;
  if (std::ranges::any_of(products_to_make(options.products), &Product::reads_classes))
    p.classes = ClassColumns::written;
  p.block_points = p.run_points = block_points;
  return p;
}

// Reads all points. Sets the lattice in the parameters and the context.
PointSurvey survey_all(const RunOptions& options, const RunInputs& inputs, IndexParams& params, PassContext& context,
                       Progress& progress) {
  InputLattice lattice = common_lattice(inputs.readers, inputs.crs.metres_per_unit, params.finest_step);
  for (;;) {
    params.unit = lattice.unit;
    params.multiple = lattice.multiple;
    set_lattice(options, inputs, lattice, context);
    progress.begin_stage("survey", inputs.points);
    PointSurvey survey = survey_points(inputs.readers, params, context);
    progress.end_stage();
    if (survey.lattice == lattice) {
      context.corner = survey.corner;
      return survey;
    }
    lattice = survey.lattice;
  }
}

CloudMeasure measure_of(const RunInputs& inputs, const IndexParams& params, const PointSurvey& survey,
                        const PassContext& context, Progress& progress) {
  if (survey.measure) return *survey.measure;
  progress.begin_stage("measure", inputs.points);
  const CloudMeasure measure = measure_points(inputs.readers, params, survey, context);
  progress.end_stage();
  return measure;
}

void freeze_survey(const fs::path& folder, const PointSurvey& survey, const RunInputs& inputs,
                   const PassContext& context, Plan& plan) {
  plan.lattice = survey.lattice;
  plan.rounding = context.rounding;
  plan.corner = survey.corner;
  plan.stray_bits = survey.strays.bits();
  plan.strays = survey.strays.cells();
  plan.points = inputs.points;
  for (std::size_t i = 0; i < kRejections; ++i)
    if (survey.rejected[i] > 0) plan.rejected[kRejectionNames[i]] = survey.rejected[i];
  fs::remove_all(folder / kChunksFolder);
  fs::create_directories(folder / kChunksFolder);
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    plan.inputs[i].box = survey.chunks[i].all();
    write_chunks(folder / kChunksFolder / std::to_string(i + 1), survey.chunks[i]);
  }
}

// The sites that are found in the cloud: this alone needs a store of all points.
std::vector<PlannedSite> found_sites(const PlanOptions& options, const RunInputs& inputs, const IndexParams& params,
                                     const PassContext& context, Progress& progress, RunRecord& record, Plan& plan) {
  const fs::path store = options.run.store.empty() ? options.run.output / ".store" : options.run.store;
  fs::remove_all(store);
  fs::create_directories(store);
  open_flushed(store);
  progress.begin_stage("index", inputs.points);
  const IndexResult index = build_index(inputs.readers, params, store, context);
  progress.end_stage();
  if (!(index.lattice == InputLattice{params.unit, params.multiple}))
    throw Error("the inputs changed while the plan was made; make it again");
  std::vector<PlannedSite> sites = find_sites(options, index.store, context, progress, record, plan);
  fs::remove_all(store);
  return sites;
}

void freeze_roofs(const PointSurvey& survey, std::span<const PlannedSite> sites, const PassContext& context,
                  RunRecord& record, Plan& plan) {
  plan.roofs.frame = roof_frame(survey.box, survey.lattice.unit, sites, context);
  if (record.footprints) record.footprints->overlaps = overlaps_of(sites, map_of_outlines(sites));
  plan.roofs.footprints = record.footprints;
  plan.roofs.extent = extent_of_points(survey.box, survey.lattice.unit * context.metres_per_unit);
  plan.roofs.sites = sites.size();
  if (plan.roofs.by_shape)
    plan.chosen.push_back({"roofs.trust_classes", std::string("false"),
                           "no point of classes.building is used; ground and buildings are found by shape"});
  plan.chosen.insert(plan.chosen.end(), record.chosen.begin(), record.chosen.end());
}

Plan begun(const PlanOptions& options, const RunInputs& inputs, const RunRecord& record) {
  Plan plan;
  plan.version = version();
  plan.git_hash = git_hash();
  plan.products = options.run.products;
  plan.parts = options.parts;
  plan.labels = options.labels && !carries_points(plan);
  plan.settings = options.run.settings;
  plan.crs_option = options.run.crs;
  plan.dialect = options.run.dialect;
  plan.crs = inputs.crs;
  plan.stations = inputs.stations;
  if (!options.run.stations.empty()) plan.stations_file = fs::absolute(options.run.stations).lexically_normal();
  for (const InputRecord& input : record.inputs) {
    PlanInput& i = plan.inputs.emplace_back();
    i.record = input;
    if (!is_remote(input.path)) i.record.path = fs::absolute(input.path).lexically_normal().string();
    i.ends = ends_of(input.path);
    i.date = inputs.sources[plan.inputs.size() - 1].date;
    i.stations = inputs.row_stations[plan.inputs.size() - 1];
    i.colours = has_colours(*inputs.readers[plan.inputs.size() - 1]);
  }
  parallel_for(plan.inputs.size(), [&](std::size_t i) { plan.inputs[i].sha256 = sum_of_file(record.inputs[i].path); });
  return plan;
}

// Everything but the points was checked before this: from here on the folder is written.
void fill_folder(const PlanOptions& options, const RunInputs& inputs, std::vector<PlannedSite> given,
                 Progress& progress, RunRecord& record) {
  const RunOptions& run = options.run;
  const fs::path folder = run.output;
  fs::remove_all(folder / ".store");  // of a start that was stopped
  Plan plan = begun(options, inputs, record);
  const std::uint64_t block_points = affordable_block_points(run, thread_count());
  PassContext context = pass_context(run, inputs, block_points, progress);
  IndexParams params = params_of(run, block_points);
  const PointSurvey survey = survey_all(run, inputs, params, context, progress);
  warn_of_strays(survey.rejected[static_cast<std::size_t>(Rejection::stray)], progress, record);
  if (survey.points == 0) throw Error("none of the points of the inputs can be used; ilot info says why");
  if (carries_points(plan)) refuse_many_tiles(survey.tiles);  // the merge makes one store
  warn_of_unsuited(run.products, inputs, measure_of(inputs, params, survey, context, progress), progress, record);
  freeze_survey(folder, survey, inputs, context, plan);
  if (makes_roofs(plan)) {
    if (run.footprints.empty())
      given = found_sites(options, inputs, params, context, progress, record, plan);
    else
      find_roles(survey.classes, plan);
    freeze_roofs(survey, given, context, record, plan);
  }
  cut_plan(options, survey.lattice.unit * context.metres_per_unit, survey, given, plan);
  plan.skipped = record.skipped;
  plan.warnings = record.warnings;
  fs::create_directories(folder / kPartsFolder);
  if (!options.update.empty()) {
    const std::uint64_t kept = keep_parts(options.update, read_plan(options.update), plan, folder);
    progress.note(fmt::format("{} of {} keep their part from {}; the tasks of the others are left", grouped(kept),
                              counted(plan.areas.size(), "area"), options.update.string()));
  }
  write_whole_file(folder / kPlanFile, plan_text(plan));
}

}  // namespace

PlanOptions options_of_update(PlanOptions given) {
  take_options(read_plan(given.update), given);
  given.statistics = given.update;
  return given;
}

int make_plan(const PlanOptions& options, Progress& progress) {
  int code = 0;
  const RunOptions& run = options.run;
  with_threads(affordable_threads(run.memory_bytes, run.threads > 0 ? run.threads : hardware_threads()), [&] {
    progress.run_start("ilot plan");
    check_products(options);
    check_folder(options);
    check_parts(options);
    const FolderLock lock(run.output, "or give another -o");
    RunRecord record;
    const RunInputs inputs = open_inputs(run, progress, record);
    check_crs(run, inputs, record);
    check_settings(run.settings, inputs);
    std::vector<PlannedSite> given;
    if (!run.footprints.empty()) given = plan_footprints(run.footprints, run.id_field, inputs.crs, progress, record);
    set_memory_limit(memory_to_fill(run));
    const KeptColumns kept;
    fill_folder(options, inputs, std::move(given), progress, record);
    warn_of_peak(run.memory_bytes, progress);
    progress.run_done(plan_estimate(run.output));
    code = static_cast<int>(record.skipped.empty() ? ExitCode::ok : ExitCode::incomplete);
  });
  return code;
}

std::string plan_estimate(const fs::path& folder) {
  const Plan plan = read_plan(folder);
  std::uint64_t points = 0, bytes = 0, parts = 0, memory = 0, most = 0;
  double seconds = 0;
  for (const PlanArea& a : plan.areas) {
    points += a.points;
    bytes += a.input_bytes;
    parts += a.part_bytes;
    seconds += a.processor_seconds;
    memory = std::max(memory, a.memory_bytes);
    most = std::max(most, a.points);
  }
  const auto mebibytes = [](std::uint64_t b) { return grouped((b >> 20) + 1) + " MiB"; };
  std::string text = counted(plan.areas.size(), "area") + " of " + fmt::format("{:.0f}", plan.area_size) + " m, " +
                     what_is_made(plan) + ", halo " + fmt::format("{:.1f}", plan.halo) + " m (" + plan.halo_why + ")\n";
  text += "tasks    " + grouped(points) + " of " + grouped(plan.points) + " points to work on, some several times; " +
          grouped(most) + " in the largest; about " + fmt::format("{:.0f}", std::ceil(seconds)) +
          " s of processor time\n";
  text += "         " + mebibytes(bytes) + " of inputs to open, --memory " + std::to_string((memory >> 20) + 1) +
          "M at least, about " + mebibytes(parts) + " of parts\n";
  return text + "next     ilot task " + folder.string() + " N for N from 1 to " + std::to_string(plan.areas.size()) +
         ", then ilot merge " + folder.string() + " -o OUT; ilot plan " + folder.string() +
         " --as make (slurm, snakemake, dask, k8s) writes what runs them";
}

}  // namespace ilot
