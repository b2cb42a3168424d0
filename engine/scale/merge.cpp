// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <queue>

#include "engine/deliverables/report/report.h"
#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/products/planes/product.h"
#include "engine/products/roofs/footprint_outcome.h"
#include "engine/products/roofs/make_roofs.h"
#include "engine/products/roofs/product.h"
#include "engine/products/roofs/roof_sink.h"
#include "engine/report/counted.h"
#include "engine/report/product_files.h"
#include "engine/report/resources.h"
#include "engine/report/sha256.h"
#include "engine/run/folder_lock.h"
#include "engine/run/inputs/input_crs.h"
#include "engine/run/result_swap.h"
#include "engine/scale/label_store.h"
#include "engine/scale/merge_planes.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/plan.h"
#include "engine/scale/records.h"
#include "engine/scale/site_records.h"
#include "engine/scale/work_folder.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// The own sites of an area, front to back, which is the order of their numbers.
class OwnSites {
 public:
  OwnSites(const fs::path& path, std::size_t buffer) : path_(path), file_(path, buffer) {}
  std::optional<NumberedSite> next() {
    try {
      while (const auto record = file_.next())
        if (NumberedSite site = numbered_site(*record); site.own) return site;
    } catch (const nlohmann::json::exception&) {
      throw Error(path_.string() + ": is damaged; make the plan again");
    }
    return std::nullopt;
  }

 private:
  fs::path path_;
  RecordFileReader file_;
};

// A building with what the plan knows of its site.
struct MergedSite {
  std::uint64_t number = 0;
  bool outside = false;
  BuiltSite built;
};

// The buildings of one part, one for each own site of the area.
class PartReader {
 public:
  PartReader(const fs::path& plan, const std::string& area, std::size_t buffer)
      : path_(plan / kPartsFolder / area), sites_(plan / kSitesFolder / area, buffer), file_(path_, buffer) {
    advance();
  }
  bool ended() const { return ended_; }
  std::uint64_t number() const { return next_.number; }
  MergedSite take() {
    MergedSite site = std::move(next_);
    advance();
    return site;
  }
  const ShiftCounts& shifts() const { return shifts_; }

 private:
  [[noreturn]] void damaged() const { throw Error(path_.string() + ": is damaged; remove it and run its task again"); }

  void advance() {
    try {
      const auto record = file_.next();
      const auto site = sites_.next();
      ended_ = !record || is_summary(*record);
      if (ended_ == site.has_value()) damaged();  // not one building for each site
      if (record && ended_) {
        shifts_ = summary_of(*record).shifts;
        file_.next();  // the end, which proves that the file is whole
      }
      if (!ended_) next_ = {site->number, site->outside, built_site(*record)};
    } catch (const nlohmann::json::exception&) {
      damaged();
    }
  }

  fs::path path_;
  OwnSites sites_;
  RecordFileReader file_;
  MergedSite next_;
  ShiftCounts shifts_;
  bool ended_ = false;
};

// The areas whose parts are there; throws Error for parts that cannot be merged.
std::vector<std::uint64_t> areas_with_parts(const MergeOptions& options, const Plan& plan,
                                            std::vector<std::uint64_t>& missing) {
  std::vector<std::uint64_t> found, stale;
  for (std::uint64_t area = 1; area <= plan.areas.size(); ++area) {
    const fs::path part = options.plan / kPartsFolder / std::to_string(area);
    if (!fs::exists(part))
      missing.push_back(area);
    else if (RecordFileReader(part, 1u << 12).head() != part_head(plan.areas[area - 1].key))
      stale.push_back(area);
    else
      found.push_back(area);
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
  record.chosen = plan.chosen;
  record.skipped = plan.skipped;
  record.warnings = plan.warnings;
  record.footprints = plan.roofs.footprints;
  record.clusters = plan.roofs.clusters;
  return record;
}

// What a merge keeps of all sites until the last part is read.
struct Merged {
  SiteNames names;
  ShiftCounts shifts;
  std::uint64_t labelled = 0;
};

// Hands the buildings of all parts to the sink in the order of their numbers.
Merged merge_buildings(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                       RoofSink& sink, Progress& progress) {
  // Choice: some records fit, and 10,000 parts take 320 MiB at most; with fewer parts each gets more.
  constexpr std::size_t kLeastBuffer = 1u << 15, kMostBuffer = 1u << 20, kAllBuffers = 64u << 20;
  const std::size_t buffer = std::clamp(kAllBuffers / areas.size(), kLeastBuffer, kMostBuffer);
  std::vector<std::unique_ptr<PartReader>> parts;
  using Next = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> order;
  for (const std::uint64_t area : areas) {
    parts.push_back(std::make_unique<PartReader>(options.plan, std::to_string(area), buffer));
    if (!parts.back()->ended()) order.push({parts.back()->number(), parts.size() - 1});
  }
  progress.begin_stage("merge", plan.roofs.sites, {plan.roofs.sites, "buildings"});
  Merged merged;
  while (!order.empty()) {
    stop_if_asked();
    const std::size_t n = order.top().second;
    order.pop();
    MergedSite site = parts[n]->take();
    if (!parts[n]->ended()) order.push({parts[n]->number(), n});
    merged.labelled += site.built.labelled;
    ++merged.names.sites;
    const std::string& id = site.built.result.levels.at(0).id;
    if (site.built.result.status == RoofStatus::footprint_only) {
      merged.names.all.insert(id);
      if (site.outside) merged.names.beyond.insert(id);
    }
    sink.take(site.built.result);
    progress.advance(1);
  }
  for (const auto& part : parts) add(merged.shifts, part->shifts());
  progress.end_stage();
  return merged;
}

void merge_roofs(const MergeOptions& options, const Plan& plan, const std::vector<std::uint64_t>& areas,
                 const fs::path& staging, Progress& progress, RunRecord& record) {
  const fs::path folder = staging / "roofs";
  fs::create_directories(folder);
  RoofSink sink(folder, roof_files_params(plan.roofs.frame, plan.settings, plan.crs), plan.crs, nullptr, record);
  const Merged merged = merge_buildings(options, plan, areas, sink, progress);
  sink.finish();
  // A point in two outlines counts for both buildings.
  const std::uint64_t usable = record.points.read - record.points.rejected_total();
  record.points.labelled = std::min(merged.labelled, usable);
  record.points.unlabelled = usable - record.points.labelled;
  if (plan.roofs.footprints) {
    record_misalignment(merged.shifts, progress, record);
    resolve_skipped_footprints(merged.names, progress, record);
  }
  if (record.roofs->buildings == (record.footprints ? record.footprints->outside.size() : 0)) {
    const std::string reason = why_no_building({}, false, false);
    record.skipped.push_back({"product", roofs_product().name, reason});
    progress.unit_skipped(roofs_product().name, reason);
  }
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

// What was made, for people.
std::string made(const Plan& plan, const RunRecord& record) {
  return is_of_planes(plan) ? planes_product().summary(record) : counted(record.roofs->buildings, "building");
}

const char* main_file(const Plan& plan) {
  return is_of_planes(plan) ? planes_product().main_file : roofs_product().main_file;
}

int merge_in_arena(const MergeOptions& options, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const Plan plan = read_plan(options.plan);
  if (options.labels && !is_of_planes(plan))
    throw Error("--labels: labelled clouds of a plan of roofs are not built; leave it out", ExitCode::usage);
  std::vector<std::uint64_t> missing;
  const std::vector<std::uint64_t> areas = areas_with_parts(options, plan, missing);
  const fs::path &out = options.output, staging = out / ".new";
  check_output(out);
  const FolderLock lock(out, "or give another -o");
  finish_swap(out);
  fs::remove_all(staging);
  fs::create_directories(staging);
  progress.run_start("ilot merge");
  RunRecord record = begun(plan);
  for (const std::uint64_t area : missing)
    record.skipped.push_back({"area", std::to_string(area), "there is no part of this area of the plan"});
  std::optional<WorkFolder> beside;  // labels are renamed from it to a folder of the plan
  if (options.labels) beside.emplace(options.plan, ".labels-");
  if (is_of_planes(plan))
    merge_planes(options, plan, areas, beside ? beside->path() / "store" : out / ".store", staging, progress, record);
  else
    merge_roofs(options, plan, areas, staging, progress, record);
  record.exit = record.skipped.empty() ? ExitCode::ok : ExitCode::incomplete;
  for (const std::string& name : product_files(staging))
    record.results.push_back({name, fs::file_size(staging / name)});
  record.result_hash = result_hash(staging);
  record.stages = progress.stages();
  record.threads = is_of_planes(plan) ? thread_count() : 1;
  if (is_of_planes(plan)) record.memory_bytes = options.memory_bytes;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.peak_rss_bytes = peak_resident_bytes();
  write_run_json(record, staging);
  swap_result(out, {});
  if (beside) publish_labels(beside->path() / "store", plan, options.plan, record.result_hash);
  std::string text =
      made(plan, record) + " of " + counted(areas.size(), "part") + ": " + (out / main_file(plan)).string();
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
