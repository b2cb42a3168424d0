// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/index.h"

#include <algorithm>
#include <cstdio>

#include "engine/formats/rows_in_box.h"
#include "engine/pass/pass.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBytesPerPoint = 64;

// Rows that one worker turns into runs: one stretch of a random-access file, or all of any other.
struct Task {
  std::uint32_t file = 0;
  std::uint64_t first = 0, count = 0;
};

// Rows that may lie in the area, whole stretches of the file; the others are not worth reading.
std::vector<RowRange> rows_to_read(const PointReader& reader, const IndexParams& params) {
  if (!params.filter.keep || !reader.random_access()) return {{0, reader.info().points}};
  const auto at = [&](std::int64_t lattice) { return static_cast<double>(lattice) * params.unit; };
  const IndexBox box = params.filter.keep->grown(1);  // a point may have been rounded into the box
  return rows_in_box(reader, {at(box.min.x), at(box.min.y), at(box.max.x), at(box.max.y), {}});
}

// Cuts a range of a random-access file at the boundaries, about run_points apart.
void cut_range(const std::vector<std::uint64_t>& cuts, const RowRange& range, std::uint32_t file,
               std::uint64_t run_points, std::vector<Task>& tasks) {
  std::uint64_t first = range.first;
  for (auto cut = std::upper_bound(cuts.begin(), cuts.end(), first); first < range.end; ++cut) {
    const bool last = *cut == range.end;
    if (!last && *(cut + 1) - first <= run_points) continue;
    tasks.push_back({file, first, *cut - first});
    first = *cut;
  }
}

struct Stretches {
  std::vector<Task> tasks;
  std::uint64_t skipped = 0;  // rows that need not be read
};

// Rows of one run: small inputs are cut too, so that all threads have work. A function of the inputs alone: a run that
// is resumed on another number of threads finds its runs again.
std::uint64_t rows_of_run(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params) {
  constexpr std::uint64_t kLeast = 1 << 16, kRuns = 16;
  std::uint64_t points = 0;
  for (const auto& input : inputs) points += input->info().points;
  return std::min(params.run_points, std::max(kLeast, points / kRuns));
}

Stretches stretches(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params) {
  Stretches result;
  const std::uint64_t rows = rows_of_run(inputs, params);
  for (std::uint32_t f = 0; f < inputs.size(); ++f) {
    const std::uint64_t points = inputs[f]->info().points;
    if (!inputs[f]->random_access()) {
      result.tasks.push_back({f, 0, points});
      continue;
    }
    result.skipped += points;
    const std::vector<std::uint64_t> cuts = inputs[f]->boundaries();
    for (const RowRange& range : rows_to_read(*inputs[f], params)) {
      cut_range(cuts, range, f, rows, result.tasks);
      result.skipped -= range.end - range.first;
    }
  }
  return result;
}

fs::path stem_of(const fs::path& folder, std::uint32_t file, std::uint64_t first) {
  char name[48];
  std::snprintf(name, sizeof name, "f%06u_%013llu", file, static_cast<unsigned long long>(first));
  return folder / "runs" / name;
}

// A stretch longer than a run (an input without random access) becomes several, front to back.
std::vector<SortedRun> make_runs(PointReader& reader, const Task& task, const IndexParams& params,
                                 const fs::path& folder, const PassContext& context) {
  std::vector<SortedRun> runs;
  for (std::uint64_t done = 0; done < task.count;) {
    const std::uint64_t count = std::min(task.count - done, 2 * params.run_points);
    const fs::path stem = stem_of(folder, task.file, task.first + done);
    auto found = reader.random_access() ? find_sorted_run(stem) : std::nullopt;
    if (found) context.advance(count);
    runs.push_back(found ? std::move(*found)
                         : make_sorted_run({reader, task.file, task.first + done, count}, params.unit, params.filter,
                                           stem, context.advance));
    done += count;
  }
  return runs;
}

// Runs need places, class and flags only; who reads on needs all again.
void limit_inputs(const std::vector<std::unique_ptr<PointReader>>& inputs, std::uint32_t fields) {
  for (const auto& input : inputs) input->limit_to(fields);
}

std::vector<SortedRun> all_runs(const std::vector<std::unique_ptr<PointReader>>& inputs, const std::vector<Task>& tasks,
                                const IndexParams& params, const fs::path& folder, const PassContext& context) {
  std::vector<std::vector<SortedRun>> parts(tasks.size());
  std::vector<PassTask> costs;
  for (const Task& t : tasks) costs.push_back({std::min(t.count, 2 * params.run_points) * kBytesPerPoint, t.count});
  run_pass(costs, context.budget_bytes,
           [&](std::size_t i) { parts[i] = make_runs(*inputs[tasks[i].file], tasks[i], params, folder, context); });
  std::vector<SortedRun> runs;
  for (auto& part : parts)
    for (SortedRun& run : part) runs.push_back(std::move(run));
  return runs;
}

std::vector<Block> all_blocks(const std::vector<SortedRun>& runs, const IndexParams& params, const fs::path& folder,
                              const PassContext& context) {
  const std::vector<PlannedBlock> plan = plan_blocks(runs, params.block_points);
  std::vector<Block> blocks(plan.size());
  std::vector<PassTask> costs;
  for (const PlannedBlock& p : plan) costs.push_back({p.points * kBytesPerPoint, p.points});
  run_pass(costs, context.budget_bytes, [&](std::size_t i) {
    const fs::path summary = folder / "blocks" / (plan[i].node.name() + ".block");
    if (fs::exists(summary)) {
      blocks[i] = read_column<Block>(summary).at(0);
      return;
    }
    blocks[i] = build_block(plan[i], runs, params.classes, folder / "blocks");
    write_column<Block>(summary, std::span(&blocks[i], 1));
  });
  return blocks;
}

}  // namespace

double common_unit(const std::vector<std::unique_ptr<PointReader>>& inputs, double metres_per_unit) {
  constexpr double kFinest = 1e-5;  // metres
  double unit = 0;
  for (const auto& input : inputs)
    for (const double scale : input->info().layout.scale) unit = unit == 0 ? scale : std::min(unit, scale);
  return std::max(unit, kFinest / metres_per_unit);
}

IndexResult build_index(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                        const fs::path& folder, const PassContext& context) {
  fs::create_directories(folder / "runs");
  fs::create_directories(folder / "blocks");
  const fs::path done = folder / "index";
  const fs::path rejected_path = folder / "rejected";
  std::array<std::uint64_t, kRejections> rejected{};
  if (!fs::exists(done)) {
    const auto [tasks, skipped] = stretches(inputs, params);
    rejected[static_cast<std::size_t>(Rejection::outside)] = skipped;
    context.advance(skipped);
    limit_inputs(inputs, kFieldZ | kFieldClass | kFieldFlags);
    const std::vector<SortedRun> runs = all_runs(inputs, tasks, params, folder, context);
    limit_inputs(inputs, kAllFields);
    for (const SortedRun& run : runs)
      for (std::size_t i = 0; i < kRejections; ++i) rejected[i] += run.rejected[i];
    const std::vector<Block> blocks = all_blocks(runs, params, folder, context);
    write_column<std::uint64_t>(rejected_path, rejected);
    write_column<Block>(done, blocks);
  }
  fs::remove_all(folder / "runs");
  ColumnReader<std::uint64_t>(rejected_path).read(0, rejected);
  return {Store(folder, params.unit, read_column<Block>(done)), rejected};
}

}  // namespace ilot
