// SPDX-License-Identifier: Apache-2.0
#include "engine/run/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/deliverables/report/report.h"
#include "engine/error.h"
#include "engine/labels/labelled_clouds.h"
#include "engine/pass/index.h"
#include "engine/pass/input_lattice.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/measure_store.h"
#include "engine/pass/resident.h"
#include "engine/products/facades/facade_edits.h"
#include "engine/products/planes/cells/cells.h"
#include "engine/products/planes/join/extend_pass.h"
#include "engine/products/planes/make_planes.h"
#include "engine/products/roofs/edits/class_edits.h"
#include "engine/products/roofs/footprint_plan.h"
#include "engine/products/streets/make_streets.h"
#include "engine/report/counted.h"
#include "engine/report/product_files.h"
#include "engine/report/resources.h"
#include "engine/report/run_record.h"
#include "engine/run/check_settings.h"
#include "engine/run/forced_isa.h"
#include "engine/run/inputs/area_in_crs.h"
#include "engine/run/inputs/input_crs.h"
#include "engine/run/inputs/input_places.h"
#include "engine/run/inputs/open_inputs.h"
#include "engine/run/memory_budget.h"
#include "engine/run/output_folder.h"
#include "engine/run/peak_warning.h"
#include "engine/run/products.h"
#include "engine/run/run_context.h"
#include "engine/run/run_estimate.h"
#include "engine/run/stray_warning.h"
#include "engine/run/suitability.h"
#include "kernels/core/parallel.h"
#include "kernels/geometry/box3.h"

namespace ilot {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool makes(const RunOptions& options, const char* product) {
  return std::find(options.products.begin(), options.products.end(), product) != options.products.end();
}

// Returns the box that an area needs for the same result as a run over everything: its own cells and those around them
// on which its planes depend.
std::optional<IndexBox> area_with_halo(const std::optional<Area>& area, double unit, double metres_per_unit) {
  if (!area) return std::nullopt;
  const double cell = static_cast<double>(largest_cell(unit * metres_per_unit)) * unit;
  const double halo = std::max(kCellsAround * cell, 2 * kCellMetres / metres_per_unit);
  const auto low = [&](double v) { return static_cast<std::int64_t>(std::floor((v - halo) / unit)); };
  const auto high = [&](double v) { return static_cast<std::int64_t>(std::ceil((v + halo) / unit)); };
  return column_over(low(area->min_x), low(area->min_y), high(area->max_x), high(area->max_y));
}

// Grows the box to the extent of buildings that stand in the area and reach beyond it.
void grow_to_sites(IndexBox& keep, const RunOptions& options, std::span<const PlannedSite> sites, double unit,
                   double metres_per_unit) {
  constexpr double kAround = 10;  // metres
  const auto at = [&](std::int64_t mm, double more) {
    return (static_cast<double>(mm) * 0.001 + more) / metres_per_unit;
  };
  for (const PlannedSite& site : sites) {
    if (site.outline.polygon.empty()) continue;
    const GridBox& b = site.outline.box;
    const double x0 = at(b.min_x, -kAround), y0 = at(b.min_y, -kAround), x1 = at(b.max_x, kAround),
                 y1 = at(b.max_y, kAround);
    if (x1 < options.area->min_x || x0 > options.area->max_x || y1 < options.area->min_y || y0 > options.area->max_y)
      continue;
    keep.min.x = std::min(keep.min.x, static_cast<std::int64_t>(std::floor(x0 / unit)));
    keep.min.y = std::min(keep.min.y, static_cast<std::int64_t>(std::floor(y0 / unit)));
    keep.max.x = std::max(keep.max.x, static_cast<std::int64_t>(std::ceil(x1 / unit)));
    keep.max.y = std::max(keep.max.y, static_cast<std::int64_t>(std::ceil(y1 / unit)));
  }
}

IndexParams index_params(const RunOptions& options, const RunInputs& inputs, std::span<const PlannedSite> sites,
                         std::uint64_t block_points, const InputLattice& lattice) {
  IndexParams p;
  p.unit = lattice.unit;
  p.multiple = lattice.multiple;
  for (const int code : options.settings.classes.noise) p.filter.noise.set(static_cast<std::size_t>(code));
  p.filter.keep = area_with_halo(options.area, p.unit, inputs.crs.metres_per_unit);
  if (p.filter.keep) grow_to_sites(*p.filter.keep, options, sites, p.unit, inputs.crs.metres_per_unit);
  p.finest_step = options.settings.index.finest_step;
  p.keep_places = options.clouds && !options.settings.classes.write;
  p.keep_strays = options.settings.index.keep_strays;
  for (const Product* product : products_to_make(options.products))
    if (product->reads_classes) p.classes = ClassColumns::written;
  p.block_points = block_points;
  p.run_points = block_points;
  return p;
}

// The inputs are read again when all of their points need a finer lattice than some of them.
IndexResult make_index(const RunOptions& options, const RunInputs& inputs, std::span<const PlannedSite> sites,
                       const OutputFolder& out, PassContext& context) {
  InputLattice lattice = common_lattice(inputs.readers, inputs.crs.metres_per_unit, options.settings.index.finest_step);
  for (;;) {
    set_lattice(options, inputs, lattice, context);
    IndexResult index = build_index(inputs.readers, index_params(options, inputs, sites, out.block_points(), lattice),
                                    out.store(), context);
    context.corner = index.corner;
    if (index.lattice == lattice) return index;
    lattice = index.lattice;
  }
}

void count_points(const IndexResult& index, const RunInputs& inputs, std::uint64_t labelled, RunRecord& record) {
  record.points.read = inputs.points;
  record.points.labelled = labelled;
  for (std::size_t i = 0; i < kRejections; ++i)
    if (index.rejected[i] > 0) record.points.rejected[kRejectionNames[i]] = index.rejected[i];
  record.points.unlabelled = inputs.points - labelled - record.points.rejected_total();
  record.blocks = index.store.blocks().size();
}

void note_rounding(const InputLattice& lattice, const RunInputs& inputs, Progress& progress) {
  double finest = lattice.finest();
  for (const auto& reader : inputs.readers)
    for (const double scale : reader->info().layout.scale) finest = std::min(finest, scale);
  if (finest < 0.999 * lattice.finest())
    progress.note(
        "coordinates in finer steps than index.finest_step are rounded to it; points/ keeps them as they are");
}

// Holds the edits against each other, and counts those that no requested product makes.
void check_edits(const RunOptions& options, const RunInputs& inputs, Progress& progress, RunRecord& record) {
  if (options.edits.empty()) return;
  record.edits = EditsRecord{inputs.edits.size(), 0, 0, 0, 0, 0};
  check_facade_edits(inputs.edits, inputs.crs.metres_per_unit);
  check_class_edits(inputs.edits);
  for (const Edit& edit : inputs.edits) record.edits->not_asked += !makes(options, edit.product.c_str());
  if (record.edits->not_asked == 0) return;
  record.warnings.push_back(counted(record.edits->not_asked, "edit") +
                            " not used: of products that --products does not name");
  progress.warn(record.warnings.back());
}

// Warns of files that no requested product reads.
void warn_of_unused(const RunOptions& options, Progress& progress, RunRecord& record) {
  const auto check = [&](const char* option, const std::filesystem::path& path, const char* product) {
    if (path.empty() || makes(options, product)) return;
    record.warnings.push_back(std::string(option) + " " + path.string() + " is not used: only the product " + product +
                              " reads it; add it to --products");
    progress.warn(record.warnings.back());
  };
  check("--footprints", options.footprints, "roofs");
  check("--train", options.train, "streets");
}

// Executes the run step by step. All output goes to the staging folder.
void make_products(const RunOptions& options, const RunInputs& inputs, const std::vector<PlannedSite>& sites,
                   const StreetTraining& training, OutputFolder& out, Progress& progress, RunRecord& record) {
  PassContext context = pass_context(options, inputs, out.block_points(), progress);
  if (options.clouds) check_labelled_clouds(inputs.readers, context);
  progress.begin_stage("index", inputs.points);
  const IndexResult index = make_index(options, inputs, sites, out, context);
  note_rounding(index.lattice, inputs, progress);
  warn_of_strays(index.rejected[static_cast<std::size_t>(Rejection::stray)], progress, record);
  if (index.store.points() == 0) {
    out.discard();
    throw Error(why_no_point(options.area, inputs.readers));
  }

  warn_of_unsuited(options.products, inputs, measure_store(index.store, context), progress, record);

  std::filesystem::create_directories(out.staging());
  const std::vector<const Product*> products = products_to_make(options.products);
  ProductRun work{.store = index.store,
                  .inputs = inputs,
                  .settings = options.settings,
                  .context = context,
                  .footprints = options.footprints.empty() ? nullptr : &sites,
                  .training = &training,
                  .asked = [&](const char* product) { return makes(options, product); },
                  .folder = out.staging(),
                  .progress = progress,
                  .record = record};
  make_all(products, work);
  const std::vector<ProductLabels> labels = labels_of(products, work);

  std::uint64_t labelled = 0;
  if (options.clouds) {
    progress.begin_stage("write", inputs.points);
    std::vector<std::uint64_t> counts;
    for (const auto& reader : inputs.readers) counts.push_back(reader->info().points);
    const std::optional<RowsInMemory> rows = rows_in_memory(index.store, counts, labels, context);
    if (!rows) rows_pass(index.store, labels, context);
    labelled = write_labelled_clouds(index.store, inputs.readers, labels, out.staging() / "points",
                                     {context, options.settings.classes.write, rows ? &*rows : nullptr});
    const std::vector<std::string> names = labelled_names(inputs.readers);
    for (std::size_t i = 0; i < names.size(); ++i) record.inputs[i].output = "points/" + names[i];
    progress.end_stage();
  } else {
    labelled = count_labelled(index.store, labels, context);
  }
  count_points(index, inputs, labelled, record);
}

// Returns a line for each product with what was made and the file that has it, and one for the whole run.
std::string summary(const RunOptions& options, const RunRecord& record) {
  std::string text = product_lines(options.products, record, options.output);
  const auto seconds = static_cast<std::uint64_t>(std::ceil(record.seconds));
  text += "all      " + counted(record.points.read, "point") + ", " + counted(seconds, "second") + ", peak " +
          std::to_string(record.peak_rss_bytes >> 20) + " MiB";
  if (!record.skipped.empty())
    text += ", " + grouped(record.skipped.size()) + " skipped: " + (options.output / "run.json").string() + " says why";
  return text;
}

int dry_run(const RunOptions& options, const RunInputs& inputs, std::size_t sites, Progress& progress) {
  const auto threads = static_cast<std::uint64_t>(thread_count());
  const RunEstimate needs = estimate_run(options, inputs);
  const auto seconds = static_cast<std::uint64_t>(std::ceil(needs.processor_seconds));
  const auto mebibytes = [](std::uint64_t bytes) { return std::to_string((bytes >> 20) + 1) + " MiB"; };
  progress.note("would read " + grouped(inputs.points) + " points from " + counted(inputs.readers.size(), "file") +
                " into blocks of at most " + grouped(affordable_block_points(options, thread_count())));
  if (sites > 0) progress.note("would model " + counted(sites, "outline of a building", "outlines of buildings"));
  progress.note("would take about " + grouped(seconds) + " s of processor time, " +
                grouped((seconds + threads - 1) / threads) + " s on " + counted(threads, "thread") + ", and at most " +
                mebibytes(options.memory_bytes - 1) + " of memory");
  progress.note("would need at most about " + mebibytes(needs.store_bytes) + " of disk for the store and " +
                mebibytes(needs.result_bytes) +
                " for the results; free: " + std::to_string(free_disk_bytes(options.output) >> 20) + " MiB");
  return 0;
}

// Fills in the values that are known when all products are made.
void complete_record(const RunOptions& options, Progress& progress, double start, RunRecord& record) {
  record.exit = record.skipped.empty() ? ExitCode::ok : ExitCode::incomplete;
  if (options.strict && !record.skipped.empty()) record.exit = ExitCode::failed;
  record.settings = options.settings;
  record.products = options.products;
  record.threads = thread_count();
  record.memory_bytes = options.memory_bytes;
  record.stages = progress.stages();
  record.seconds = now() - start;
  record.peak_rss_bytes = peak_resident_bytes();
  const std::string warning = warn_of_peak(record.memory_bytes, progress);
  if (!warning.empty()) record.warnings.push_back(warning);
}

// Makes the report of the finished result and returns what to open. A report that cannot be made spoils no result.
std::string report_line(const RunOptions& options, Progress& progress) {
  const std::filesystem::path& out = options.output;
  try {
    remove_report(out);
    if (!options.report) return "";
    trim_memory();  // what the products have left would be counted beside what the report takes
    write_report(out);
    return "\nopen " + (out / kReportFile).string();
  } catch (const std::exception& fault) {
    progress.warn("the result is whole, but its report cannot be made: " + std::string(fault.what()));
    return "";
  }
}

int run_in_arena(const RunOptions& given, const TrainObjectModel& learn, Progress& progress) {
  RunRecord record;
  RunOptions options = given;
  const double start = now();
  if (makes(options, "streets") && !options.train.empty() && !std::filesystem::exists(options.train))
    throw Error(options.train.string() + ": no such file", ExitCode::usage);
  std::optional<OutputFolder> out;
  if (!options.dry_run) out.emplace(options, progress);
  const RunInputs inputs = open_inputs(options, progress, record);
  record.crs = crs_record(inputs.crs);
  if (options.area) options.area = area_in_crs(*options.area, inputs, progress, record);
  check_settings(options.settings, inputs);
  check_edits(options, inputs, progress, record);
  warn_of_unused(options, progress, record);
  const std::vector<PlannedSite> sites =
      options.footprints.empty() || !makes(options, "roofs")
          ? std::vector<PlannedSite>{}
          : plan_footprints(options.footprints, options.id_field, inputs.crs, progress, record);
  if (options.dry_run) return dry_run(options, inputs, sites.size(), progress);
  const Opened opened = out->open(inputs);
  if (opened == Opened::fresh && options.existing == Existing::resume)
    progress.note(options.output.string() + ": holds no interrupted run that --resume could go on with; starts afresh");
  if (opened == Opened::finished) {
    out->finish(options.keep_store);
    progress.note(options.output.string() + ": is finished, nothing is left to do");
    return 0;
  }
  set_memory_limit(memory_to_fill(options));
  out->check_space(estimate_run(options, inputs));
  progress.plan(planned_stages(options));
  {
    const KeptColumns kept;
    make_products(options, inputs, sites, {options.train, learn}, *out, progress, record);
  }
  complete_record(options, progress, start, record);
  out->publish(record);
  out->finish(options.keep_store);
  progress.run_done(summary(options, record) + report_line(options, progress));
  return static_cast<int>(record.exit);
}

}  // namespace

int run(const RunOptions& options, Progress& progress, const TrainObjectModel& learn) {
  check_forced_isa();
  progress.run_start("ilot run");
  int code = 0;
  with_threads(affordable_threads(options.memory_bytes, options.threads > 0 ? options.threads : hardware_threads()),
               [&] { code = run_in_arena(options, learn, progress); });
  return code;
}

}  // namespace ilot
