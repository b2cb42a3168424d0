// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/index.h"

#include <algorithm>
#include <cstdio>

#include "engine/error.h"
#include "engine/formats/changed_reader.h"
#include "engine/formats/laz/laz.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/rows_in_box.h"
#include "engine/pass/input_lattice.h"
#include "engine/pass/input_stretches.h"
#include "engine/pass/pass.h"
#include "engine/store/column_cache.h"
#include "engine/store/flushed.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBytesPerPoint = 64;

// Returns rows that may be in the area, as whole stretches of the file; the others need not be read.
std::vector<RowRange> rows_to_read(const PointReader& reader, std::uint32_t file, const IndexParams& params) {
  if (!params.rows.empty()) return params.rows[file];
  if (!params.filter.keep || !reader.random_access()) return {{0, reader.info().points}};
  const auto at = [&](std::int64_t lattice) { return static_cast<double>(lattice) * params.unit; };
  const IndexBox box = params.filter.keep->grown(1);  // rounding may have moved a point into the box
  return rows_in_box(reader, {at(box.min.x), at(box.min.y), at(box.max.x), at(box.max.y), {}});
}

// What is read of the inputs.
struct Reading {
  std::vector<InputStretch> stretches;
  std::uint64_t skipped = 0;  // rows that need not be read
};

Reading reading_of(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params) {
  Reading reading;
  std::vector<std::vector<RowRange>> rows;
  for (std::uint32_t f = 0; f < inputs.size(); ++f) {
    rows.push_back(rows_to_read(*inputs[f], f, params));
    if (!inputs[f]->random_access()) continue;
    reading.skipped += inputs[f]->info().points;
    for (const RowRange& range : rows.back()) reading.skipped -= range.end - range.first;
  }
  reading.stretches = cut_inputs(inputs, rows, params.run_points);
  return reading;
}

// Which rows have their places kept: the first ones of inputs whose chunks are written again as they are, with only the
// labels added (LazExtender).
std::vector<bool> kept_places(const std::vector<std::unique_ptr<PointReader>>& inputs, std::uint64_t memory_bytes,
                              const std::vector<InputStretch>& stretches) {
  // Choice: an eighth of the memory; the rest of the cache is for columns.
  constexpr std::uint64_t kPart = 8;
  std::uint64_t bytes = 0;
  std::vector<bool> kept(stretches.size());
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto chunks = laz_chunks(reader_of_file(*inputs[stretches[i].file]));
    if (!chunks || !chunks->compression.layout.layered()) continue;
    bytes += stretches[i].count * kPlaceBytes;
    kept[i] = bytes <= memory_bytes / kPart;
  }
  return kept;
}

fs::path stem_of(const fs::path& folder, std::uint32_t file, std::uint64_t first) {
  char name[48];
  std::snprintf(name, sizeof name, "f%06u_%013llu", file, static_cast<unsigned long long>(first));
  return folder / "runs" / name;
}

// A stretch that is longer than a run (an input without random access) becomes several runs, front to back.
std::vector<SortedRun> make_runs(PointReader& reader, const InputStretch& task, bool keeps_places,
                                 const IndexParams& params, const fs::path& folder, const PassContext& context) {
  std::vector<SortedRun> runs;
  for (std::uint64_t done = 0; done < task.count;) {
    const std::uint64_t count = std::min(task.count - done, 2 * params.run_points);
    const fs::path stem = stem_of(folder, task.file, task.first + done);
    std::optional<PlaceKeeper> places;
    if (keeps_places) places.emplace(folder, task.file, reader, task.first, task.count);
    auto found = reader.random_access() ? find_sorted_run(stem) : std::nullopt;
    if (found) context.advance(count);
    runs.push_back(found ? std::move(*found)
                         : make_sorted_run({reader, task.file, task.first + done, count, places ? &*places : nullptr},
                                           {params.unit, params.multiple}, params.filter, stem, context.advance));
    done += count;
  }
  return runs;
}

std::vector<SortedRun> all_runs(const std::vector<std::unique_ptr<PointReader>>& inputs,
                                const std::vector<InputStretch>& tasks, const IndexParams& params,
                                const fs::path& folder, const PassContext& context) {
  const std::vector<bool> keeps =
      params.keep_places ? kept_places(inputs, context.memory_bytes, tasks) : std::vector<bool>(tasks.size());
  std::vector<std::vector<SortedRun>> parts(tasks.size());
  std::vector<PassTask> costs;
  for (const InputStretch& t : tasks)
    costs.push_back({std::min(t.count, 2 * params.run_points) * kBytesPerPoint + kRowBytes, t.count});
  run_pass(costs, context.budget_bytes, [&](std::size_t i) {
    parts[i] = make_runs(*inputs[tasks[i].file], tasks[i], keeps[i], params, folder, context);
  });
  std::vector<SortedRun> runs;
  for (auto& part : parts)
    for (SortedRun& run : part) runs.push_back(std::move(run));
  return runs;
}

// Returns the cells of all inputs together: a point that is isolated in its file may have neighbours in another.
CoarseCells cells_of(const std::vector<SortedRun>& runs, int bits) {
  CoarseCells cells(bits);
  for (const SortedRun& run : runs) cells.merge(coarse_cells_of(run));
  return cells;
}

// Returns how many points of the runs are in no block.
std::uint64_t left_out(const std::vector<SortedRun>& runs, const std::vector<Block>& blocks) {
  std::uint64_t points = 0;
  for (const SortedRun& run : runs)
    if (!run.tiles.empty()) points += run.tiles.back().end;
  for (const Block& block : blocks) points -= block.points;
  return points;
}

// The files that the index leaves in the folder, "index" last; "lattice" only when it is not the one that was asked for
// first.
struct IndexFiles {
  fs::path folder;
  fs::path done() const { return folder / "index"; }
  fs::path rejected() const { return folder / "rejected"; }
  fs::path corner() const { return folder / "corner"; }
  fs::path lattice() const { return folder / "lattice"; }
  fs::path strays() const { return folder / "strays"; }
};

// The file of strays begins with the bits of its cells.
void write_strays(const Strays& strays, const fs::path& path) {
  std::vector<CoarseCell> cells{{strays.bits(), 0, 0}};
  cells.insert(cells.end(), strays.cells().begin(), strays.cells().end());
  write_column<CoarseCell>(path, cells);
}

Strays read_strays(const fs::path& path) {
  if (!fs::exists(path)) return {};  // a store of an older version
  const std::vector<CoarseCell> cells = read_column<CoarseCell>(path);
  return {static_cast<int>(cells.at(0).x), {cells.begin() + 1, cells.end()}};
}

IndexResult nothing_with(const InputLattice& lattice, const fs::path& folder) {
  return {Store(folder, lattice.unit, {}), {}, lattice, {}, {}};
}

// Returns the lattice that the points need; writes the index when this is the lattice that was asked for.
InputLattice write_index(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                         const IndexFiles& files, const PassContext& context) {
  IndexParams with_cells = params;
  with_cells.filter.coarse_bits = coarse_bits(params.unit * context.metres_per_unit);
  const auto [tasks, skipped] = reading_of(inputs, params);
  context.advance(skipped);
  limit_inputs(inputs, kFieldZ | kFieldClass | kFieldFlags);  // all that runs need; later readers need the others
  const std::vector<SortedRun> runs = all_runs(inputs, tasks, with_cells, files.folder, context);
  limit_inputs(inputs, kAllFields);
  const CoarseCells cells = cells_of(runs, *with_cells.filter.coarse_bits);
  const Strays strays = params.keep_strays ? Strays() : params.strays ? *params.strays : find_strays(cells);
  const InputLattice asked{params.unit, params.multiple};
  std::vector<std::vector<Index3>> off_lattice;
  for (const SortedRun& run : runs) off_lattice.push_back(run.off_lattice);
  const InputLattice needed =
      checked_lattice(asked, inputs, off_lattice, strays, context.metres_per_unit, params.finest_step);
  if (!(needed == asked)) {
    write_column<InputLattice>(files.lattice(), std::span(&needed, 1));
    return needed;
  }
  const std::vector<Block> blocks = build_blocks(runs, params, strays, files.folder, context);
  std::array<std::uint64_t, kRejections> rejected{};
  for (const SortedRun& run : runs)
    for (std::size_t i = 0; i < kRejections; ++i) rejected[i] += run.rejected[i];
  rejected[static_cast<std::size_t>(Rejection::outside)] += skipped;
  rejected[static_cast<std::size_t>(Rejection::stray)] = left_out(runs, blocks);
  const Index3 corner = least_corner(cells, strays);
  write_column<std::uint64_t>(files.rejected(), rejected);
  write_column<Index3>(files.corner(), std::span(&corner, 1));
  write_strays(strays, files.strays());
  write_column<Block>(files.done(), blocks);
  return asked;
}

IndexResult finished_index(const IndexFiles& files, const InputLattice& lattice) {
  IndexResult result{Store(files.folder, lattice.unit, read_column<Block>(files.done())), {}, lattice, {}, {}};
  ColumnReader<std::uint64_t>(files.rejected()).read(0, result.rejected);
  result.corner = read_column<Index3>(files.corner()).at(0);
  result.strays = read_strays(files.strays());
  return result;
}

}  // namespace

std::vector<Block> build_blocks(const std::vector<SortedRun>& runs, const IndexParams& params, const Strays& strays,
                                const fs::path& folder, const PassContext& context) {
  const std::vector<PlannedBlock> plan = plan_blocks(runs, params.block_points, strays);
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

IndexResult build_index(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                        const fs::path& folder, const PassContext& context) {
  const InputLattice asked{params.unit, params.multiple};
  const IndexFiles files{folder};
  if (fs::exists(files.lattice())) {
    const InputLattice needed = read_column<InputLattice>(files.lattice()).at(0);
    if (!(needed == asked)) return nothing_with(needed, folder);
  }
  if (!fs::exists(files.done())) {
    fs::create_directories(folder / "runs");
    fs::create_directories(folder / "blocks");
    const InputLattice needed = write_index(inputs, params, files, context);
    fs::remove_all(folder / "runs");
    forget_folder(folder / "runs");
    if (!(needed == asked)) return nothing_with(needed, folder);
  }
  IndexResult result = finished_index(files, asked);
  flush_pass(result.store, Pass::index);
  return result;
}

IndexResult open_index(const fs::path& folder, const InputLattice& first) {
  const IndexFiles files{folder};
  if (!fs::exists(files.done())) throw Error(folder.string() + ": contains no finished store");
  return finished_index(files, fs::exists(files.lattice()) ? read_column<InputLattice>(files.lattice()).at(0) : first);
}

}  // namespace ilot
