// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/task_inputs.h"

#include <filesystem>

#include "engine/error.h"
#include "engine/formats/remote_file.h"
#include "engine/run/memory_budget.h"
#include "engine/run/run_context.h"
#include "engine/run/run_request.h"
#include "kernels/core/parallel.h"

namespace ilot {

namespace fs = std::filesystem;

namespace {

// A server that does not answer may do so later.
std::uint64_t remote_bytes(const fs::path& path) {
  try {
    return RemoteFile(path).size();
  } catch (const Error& fault) {
    throw Error(fault.what(), ExitCode::try_again);
  }
}

}  // namespace

void check_inputs(const Plan& plan, std::span<const std::uint32_t> numbers) {
  for (const std::uint32_t i : numbers) {
    const PlanInput& input = plan.inputs.at(i);
    const fs::path path = input.record.path;
    std::error_code code;
    const std::uint64_t bytes = is_remote(path) ? remote_bytes(path) : fs::file_size(path, code);
    if (code) throw Error(path.string() + ": the plan needs this input, and it is not there; put it back");
    if (bytes != input.record.bytes || ends_of(path) != input.ends)
      throw Error(path.string() + ": was changed after the plan was made; make the plan again");
  }
}

RunOptions run_options(const TaskOptions& task, const Plan& plan, std::span<const std::uint32_t> numbers) {
  RunOptions options;
  for (const std::uint32_t i : numbers) options.inputs.emplace_back(plan.inputs[i].record.path);
  options.products = plan.products;
  options.settings = plan.settings;
  options.crs = plan.crs_option;
  options.dialect = plan.dialect;
  options.memory_bytes = task.memory_bytes;
  options.threads = task.threads;
  options.clouds = false;
  return options;
}

RunInputs open_needed(const RunOptions& options, const Plan& plan, std::span<const std::uint32_t> numbers) {
  if (options.inputs.empty()) {
    RunInputs none;
    none.crs = plan.crs;
    return none;
  }
  Progress silent;  // the plan has told what there is to say of the inputs
  RunRecord record;
  RunInputs inputs = open_inputs(options, silent, record);
  if (inputs.readers.size() != options.inputs.size())
    throw Error(record.skipped.empty() ? "an input cannot be read" : record.skipped.front().reason);
  if (inputs.crs.metres_per_unit != plan.crs.metres_per_unit)
    throw Error(options.inputs[0].string() + ": gives another CRS alone than with the others; make the plan with --crs",
                ExitCode::usage);
  inputs.stations = plan.stations;  // rows have numbers among those of all inputs
  inputs.row_stations.clear();
  for (const std::uint32_t i : numbers) inputs.row_stations.push_back(plan.inputs[i].stations);
  return inputs;
}

RunInputs frozen_inputs(const Plan& plan) {
  RunInputs inputs;
  inputs.crs = plan.crs;
  inputs.points = plan.points;
  inputs.stations = plan.stations;
  for (const PlanInput& input : plan.inputs) {
    inputs.sources.push_back({fs::path(input.record.path).filename().string(), input.date});
    inputs.row_stations.push_back(input.stations);
  }
  return inputs;
}

PassContext frozen_context(const RunOptions& options, const RunInputs& inputs, const Plan& plan, Progress& progress) {
  PassContext context = pass_context(options, inputs, affordable_block_points(options, thread_count()), progress);
  context.metres_per_unit = plan.crs.metres_per_unit;
  context.rounding = plan.rounding;
  context.corner = plan.corner;
  return context;
}

}  // namespace ilot
