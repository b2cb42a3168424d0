// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge/merge.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "engine/deliverables/report/report.h"
#include "engine/error.h"
#include "engine/pass/resident.h"
#include "engine/report/counted.h"
#include "engine/report/product_files.h"
#include "engine/report/resources.h"
#include "engine/report/sha256.h"
#include "engine/run/folder_lock.h"
#include "engine/run/inputs/input_crs.h"
#include "engine/run/peak_warning.h"
#include "engine/run/products.h"
#include "engine/run/result_swap.h"
#include "engine/scale/label_store.h"
#include "engine/scale/merge/merge_roofs.h"
#include "engine/scale/merge/merge_store.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/parts/part_place.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_products.h"
#include "engine/scale/records.h"
#include "engine/scale/work_folder.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// What stands at the beginning of each part, by area; in a store each takes two requests.
std::vector<PartState> states_of_parts(const MergeOptions& options, const Plan& plan) {
  std::vector<PartState> states(plan.areas.size());
  parallel_for(states.size(), [&](std::size_t i) {
    const fs::path part = parts_of(plan, options.plan) / std::to_string(i + 1);
    if (!part_exists(part))
      states[i] = PartState::missing;
    else if (RecordFileReader(part, 1u << 12).head() != part_head(plan.areas[i].key))
      states[i] = PartState::stale;
    else
      states[i] = PartState::whole;
  });
  return states;
}

// The areas whose parts are there; throws Error for parts that cannot be merged.
std::vector<std::uint64_t> areas_with_parts(const MergeOptions& options, const Plan& plan,
                                            std::vector<std::uint64_t>& missing) {
  std::vector<std::uint64_t> found, stale;
  const std::vector<PartState> states = states_of_parts(options, plan);
  for (std::uint64_t area = 1; area <= states.size(); ++area) {
    const PartState state = states[area - 1];
    (state == PartState::missing ? missing : state == PartState::stale ? stale : found).push_back(area);
  }
  const auto named = [](const std::vector<std::uint64_t>& areas) {
    constexpr std::size_t kNamed = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(areas.size(), kNamed); ++i)
      text += (i == 0 ? "" : ", ") + std::to_string(areas[i]);
    return text + (areas.size() > kNamed ? " and " + grouped(areas.size() - kNamed) + " more" : "");
  };
  if (!stale.empty())
    throw Error(options.plan.string() + ": parts of another plan: " + named(stale) + "; run ilot task for them again",
                ExitCode::usage);
  if (!missing.empty() && !options.allow_missing)
    throw Error(options.plan.string() + ": " + counted(missing.size(), "area has", "areas have") +
                    " no part: " + named(missing) + "; run ilot task for them, or give --allow-missing",
                ExitCode::usage);
  if (found.empty()) throw Error(options.plan.string() + ": no area has a part yet", ExitCode::usage);
  return found;
}

RunRecord begun(const Plan& plan) {
  RunRecord record;
  record.settings = plan.settings;
  record.products = plan.products;
  for (const PlanInput& input : plan.inputs) record.inputs.push_back(input.record);
  record.crs = crs_record(plan.crs);
  record.unit_assumed = plan.crs.unit_assumed;
  record.points.read = plan.points;
  record.points.rejected = plan.rejected;
  record.skipped = plan.skipped;
  record.warnings = plan.warnings;
  record.footprints = plan.roofs.footprints;
  record.clusters = plan.roofs.clusters;
  return record;
}

void check_output(const fs::path& out) {
  if (!fs::exists(out)) return;
  if (!fs::is_directory(out)) throw Error(out.string() + ": is not a folder", ExitCode::usage);
  if (fs::exists(out / "run.json")) throw Error(out.string() + ": exists already; give another -o", ExitCode::usage);
  for (const auto& entry : fs::directory_iterator(out))
    if (!entry.path().filename().string().starts_with("."))
      throw Error(out.string() + ": contains something else than an unfinished merge; give another -o",
                  ExitCode::usage);
}

// Adds what is known of the finished files, and writes run.json beside them.
void finish_record(const fs::path& staging, std::uint64_t memory_bytes, Progress& progress, RunRecord& record) {
  record.exit = record.skipped.empty() ? ExitCode::ok : ExitCode::incomplete;
  for (const std::string& name : product_files(staging))
    record.results.push_back({name, fs::file_size(staging / name)});
  record.result_hash = result_hash(staging);
  record.stages = progress.stages();
  record.peak_rss_bytes = peak_resident_bytes();
  const std::string warning = warn_of_peak(memory_bytes, progress);
  if (!warning.empty()) record.warnings.push_back(warning);
  write_run_json(record, staging);
}

void merge_roofs_alone(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                       const fs::path& staging, Progress& progress, RunRecord& record) {
  const MergedRoofs roofs = merge_roofs(options.plan, plan, {plan.chosen, {}}, parts_of(plan, options.plan), areas,
                                        staging, progress, record);
  const std::uint64_t usable = record.points.read - record.points.rejected_total();
  record.points.labelled = std::min(roofs.labelled, usable);
  record.points.unlabelled = usable - record.points.labelled;
}

int merge_in_arena(const MergeOptions& options, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const Plan plan = read_plan(options.plan);
  const bool points = carries_points(plan);
  if (options.labels && !points)
    throw Error("--labels: the parts of this plan have no points; make it with ilot plan --labels", ExitCode::usage);
  std::vector<std::uint64_t> missing;
  const std::vector<std::uint64_t> areas = areas_with_parts(options, plan, missing);
  const fs::path &out = options.output, staging = out / ".new";
  check_output(out);
  const FolderLock lock(out, "or give another -o");
  finish_swap(out);
  fs::remove_all(staging);
  fs::remove_all(out / ".store");  // of a merge that was killed
  fs::create_directories(staging);
  progress.run_start("ilot merge");
  RunRecord record = begun(plan);
  for (const std::uint64_t area : missing)
    record.skipped.push_back({"area", std::to_string(area), "there is no part of this area of the plan"});
  std::optional<WorkFolder> beside;  // labels are renamed from it to a folder of the plan
  if (options.labels) beside.emplace(options.plan, ".labels-");
  if (points)
    merge_store(options, plan, areas, beside ? beside->path() / "store" : out / ".store", staging, progress, record);
  else
    merge_roofs_alone(options, plan, areas, staging, progress, record);
  record.threads = points ? thread_count() : 1;
  if (points) record.memory_bytes = options.memory_bytes;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  finish_record(staging, options.memory_bytes, progress, record);
  swap_result(out, {});
  if (beside) publish_labels(beside->path() / "store", plan, options.plan, record.result_hash);
  std::string text = product_lines(plan.products, record, out) + "all      " + counted(areas.size(), "part");
  if (!missing.empty()) text += ", " + counted(missing.size(), "area is", "areas are") + " missing";
  if (options.report) write_report(out);
  progress.run_done(text + (options.report ? "\nopen " + (out / kReportFile).string() : ""));
  return static_cast<int>(record.exit);
}

}  // namespace

int merge_parts(const MergeOptions& options, Progress& progress) {
  const int wanted = options.threads > 0 ? options.threads : hardware_threads();
  int code = 0;
  with_threads(affordable_threads(options.memory_bytes, wanted), [&] { code = merge_in_arena(options, progress); });
  return code;
}

}  // namespace ilot
