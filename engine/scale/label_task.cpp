// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/label_task.h"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/labels/labelled_clouds.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/resident.h"
#include "engine/report/path_text.h"
#include "engine/report/product_files.h"
#include "engine/report/sha256.h"
#include "engine/run/memory_budget.h"
#include "engine/scale/label_store.h"
#include "engine/scale/task_inputs.h"
#include "engine/scale/work_folder.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kClouds = "points";

std::vector<std::string> names_of(const Plan& plan) {
  std::vector<fs::path> paths;
  for (const PlanInput& input : plan.inputs) paths.emplace_back(input.record.path);
  return labelled_names(paths);
}

constexpr const char* kMerged = "merged_hash";  // what result_hash was before the clouds

nlohmann::ordered_json record_of_result(const fs::path& out, const Plan& plan, const std::string& merged) {
  std::ifstream file(out / "run.json");
  auto record = nlohmann::ordered_json::parse(file, nullptr, false);
  bool same = record.is_object() && record["inputs"].is_array() && record["inputs"].size() == plan.inputs.size();
  for (std::size_t i = 0; same && i < plan.inputs.size(); ++i)
    same = record["inputs"][i].value("path", "") == path_text(plan.inputs[i].record.path);
  same = same && (record.value("result_hash", "") == merged || record.value(kMerged, "") == merged);
  if (!same)
    throw Error(
        out.string() + ": has not the result of the last merge of this plan; run ilot merge with --labels first",
        ExitCode::usage);
  return record;
}

// Does nothing while a cloud is missing, or where another task has done it. Tasks that end together write the same
// bytes.
void complete_record(const fs::path& out, const Plan& plan, const std::vector<std::string>& names,
                     const std::string& merged, const fs::path& work) {
  for (const std::string& name : names)
    if (!fs::exists(out / kClouds / name)) return;
  auto record = record_of_result(out, plan, merged);
  if (record.contains(kMerged)) return;
  record[kMerged] = merged;
  for (std::size_t i = 0; i < names.size(); ++i)
    record["inputs"][i]["output"] = path_text(std::string(kClouds) + "/" + names[i]);
  auto& results = record["results"] = nlohmann::ordered_json::array();
  for (const std::string& name : product_files(out))
    results.push_back({{"path", path_text(name)}, {"bytes", fs::file_size(out / name)}});
  record["result_hash"] = result_hash(out);
  write_whole_file(work / "run.json", record.dump(2) + "\n");
  fs::rename(work / "run.json", out / "run.json");
}

}  // namespace

void label_input(const TaskOptions& task, const Plan& plan, Progress& progress) {
  const auto number = static_cast<std::uint32_t>(task.number - 1);
  const std::vector<std::string> names = names_of(plan);
  const fs::path cloud = task.output / kClouds / names[number];
  const KeptLabels kept = open_labels(plan, task.plan, plan.inputs[number].box);
  record_of_result(task.output, plan, kept.result_hash);
  const WorkFolder work(task.output, ".label-" + std::to_string(task.number) + "-");
  if (fs::exists(cloud)) {
    progress.note(cloud.string() + ": is done, nothing is left to do");
    return complete_record(task.output, plan, names, kept.result_hash,
                           work.path());  // the task that wrote it may have died before
  }
  const std::array numbers{number};
  check_inputs(plan, numbers);
  const RunOptions options = run_options(task, plan, numbers);
  const RunInputs inputs = open_needed(options, plan, numbers);
  set_memory_limit(memory_to_fill(options));
  const KeptColumns kept_columns;
  const PassContext context = frozen_context(options, inputs, plan, progress);
  check_labelled_clouds(inputs.readers, context);
  progress.begin_stage("write", inputs.points);
  write_labelled_cloud(kept.store, *inputs.readers[0], number, kept.labels, work.path() / names[number],
                       {context, options.settings.classes.write});
  progress.end_stage();
  check_inputs(plan, numbers);  // a change while the task read
  fs::create_directories(cloud.parent_path());
  fs::rename(work.path() / names[number], cloud);
  complete_record(task.output, plan, names, kept.result_hash, work.path());
  progress.run_done(cloud.string());
}

}  // namespace ilot
