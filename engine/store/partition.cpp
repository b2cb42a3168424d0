// SPDX-License-Identifier: Apache-2.0
#include "engine/store/partition.h"

#include <algorithm>
#include <map>
#include <memory>

#include "engine/error.h"
#include "kernels/core/radix_sort.h"

namespace ilot {
namespace {

// Returns the first position in [range.first, range.end) whose code is not below `code`.
std::uint64_t lower_bound(const SortedRun& run, const ColumnReader<KeyValue>& points, const RunRange& range,
                          std::uint64_t code) {
  std::uint64_t lo = range.first, hi = range.end;
  const std::uint64_t first_sample = (lo + kRunSample - 1) / kRunSample;
  const std::uint64_t last_sample = (hi + kRunSample - 1) / kRunSample;
  const auto begin = run.samples.begin() + static_cast<std::ptrdiff_t>(first_sample);
  const auto end = run.samples.begin() + static_cast<std::ptrdiff_t>(std::max(first_sample, last_sample));
  const auto it = std::lower_bound(begin, end, code);
  if (it != begin) lo = std::max(lo, static_cast<std::uint64_t>(it - run.samples.begin() - 1) * kRunSample);
  if (it != end) hi = std::min(hi, static_cast<std::uint64_t>(it - run.samples.begin()) * kRunSample);
  if (lo == hi) return lo;
  std::vector<KeyValue> page(hi - lo);
  points.read(lo, page);
  const auto below = [](const KeyValue& point, std::uint64_t c) { return point.key < c; };
  return lo + static_cast<std::uint64_t>(std::lower_bound(page.begin(), page.end(), code, below) - page.begin());
}

// Returns the ranges of a run's points of a tile that remain without the codes of strays.
std::vector<RunRange> without(std::span<const CodeRange> strays, const SortedRun& run, const RunRange& range) {
  if (strays.empty()) return {range};
  const ColumnReader<KeyValue> points(with_suffix(run.stem, ".points"));
  std::vector<RunRange> kept;
  RunRange rest = range;
  const auto keep_to = [&](std::uint64_t end) {
    if (end > rest.first) kept.push_back({rest.run, rest.first, end});
  };
  for (const CodeRange& codes : strays) {
    keep_to(lower_bound(run, points, rest, codes.first));
    rest.first = codes.last == UINT64_MAX ? rest.end : lower_bound(run, points, rest, codes.last + 1);
  }
  keep_to(rest.end);
  return kept;
}

class Planner {
 public:
  Planner(std::span<const SortedRun> runs, std::uint64_t block_points) : runs_(runs), block_points_(block_points) {}

  void split(const PlannedBlock& block, std::vector<PlannedBlock>& leaves) const {
    if (block.points == 0) return;
    if (block.points <= block_points_ || block.node.level == kTileBits) {
      leaves.push_back(block);
      return;
    }
    std::array<PlannedBlock, 8> children;
    for (int octant = 0; octant < 8; ++octant)
      children[static_cast<std::size_t>(octant)].node = block.node.child(octant);
    for (const RunRange& range : block.ranges) {
      const ColumnReader<KeyValue> points(with_suffix(runs_[range.run].stem, ".points"));
      std::uint64_t first = range.first;
      for (std::size_t octant = 0; octant < 8; ++octant) {
        const std::uint64_t end = octant == 7 ? range.end
                                              : lower_bound(runs_[range.run], points, {range.run, first, range.end},
                                                            children[octant + 1].node.first_code);
        if (end > first) {
          children[octant].ranges.push_back({range.run, first, end});
          children[octant].points += end - first;
        }
        first = end;
      }
    }
    for (const PlannedBlock& child : children) split(child, leaves);
  }

 private:
  std::span<const SortedRun> runs_;
  std::uint64_t block_points_;
};

// Returns the points of all ranges, sorted.
std::span<KeyValue> merge(const PlannedBlock& plan, std::span<const SortedRun> runs, std::span<KeyValue> memory) {
  const std::span<KeyValue> points = memory.first(plan.points);
  std::uint64_t at = 0;
  for (const RunRange& range : plan.ranges) {
    const std::uint64_t n = range.end - range.first;
    ColumnReader<KeyValue>(with_suffix(runs[range.run].stem, ".points")).read(range.first, points.subspan(at, n));
    at += n;
  }
  if (plan.ranges.size() > 1) sort_pairs(points, memory.subspan(plan.points));
  return points;
}

std::vector<ChunkBox> chunk_boxes(std::span<const KeyValue> points) {
  std::vector<ChunkBox> boxes;
  for (std::size_t first = 0; first < points.size(); first += kChunkPoints) {
    ChunkBox box{{UINT32_MAX, UINT32_MAX, UINT32_MAX}, {0, 0, 0}};
    for (std::size_t i = first; i < std::min(points.size(), first + kChunkPoints); ++i) {
      const Cell3 c = morton_cell(points[i].key);
      const std::uint32_t v[3]{c.x, c.y, c.z};
      for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::min(box.min[axis], v[axis]);
        box.max[axis] = std::max(box.max[axis], v[axis]);
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

// Writes one value for each point as a column, through a small buffer.
template <class T, class Get>
void write_values(const std::string& stem, const Column<T>& column, std::span<const KeyValue> points, const Get& get) {
  constexpr std::size_t kBuffer = 1 << 13;
  ColumnWriter<T> file(stem + column.info.name);
  std::vector<T> buffer(kBuffer);
  for (std::size_t first = 0; first < points.size(); first += kBuffer) {
    const std::size_t n = std::min(kBuffer, points.size() - first);
    for (std::size_t i = 0; i < n; ++i) buffer[i] = get(points[first + i]);
    file.append(std::span<const T>(buffer).first(n));
  }
  file.commit();
}

IndexBox bounds(std::span<const ChunkBox> chunks, Tile tile) {
  const Index3 c = corner(tile);
  ChunkBox all = chunks[0];
  for (const ChunkBox& b : chunks)
    for (int axis = 0; axis < 3; ++axis) {
      all.min[axis] = std::min(all.min[axis], b.min[axis]);
      all.max[axis] = std::max(all.max[axis], b.max[axis]);
    }
  return {{c.x + all.min[0], c.y + all.min[1], c.z + all.min[2]},
          {c.x + all.max[0], c.y + all.max[1], c.z + all.max[2]}};
}

}  // namespace

std::vector<PlannedBlock> plan_blocks(std::span<const SortedRun> runs, std::uint64_t block_points,
                                      const Strays& strays) {
  std::map<Tile, PlannedBlock> roots;
  for (std::uint32_t r = 0; r < runs.size(); ++r) {
    for (const RunTile& t : runs[r].tiles) {
      PlannedBlock& root = roots[t.tile];
      refuse_many_tiles(roots.size());
      root.node = {t.tile, 0, 0};
      for (const RunRange& range : without(strays.in_tile(t.tile), runs[r], {r, t.first, t.end})) {
        root.points += range.end - range.first;
        root.ranges.push_back(range);
      }
    }
  }
  const Planner planner(runs, block_points);
  std::vector<PlannedBlock> leaves;
  for (const auto& [tile, root] : roots) planner.split(root, leaves);
  return leaves;
}

Block build_block(const PlannedBlock& plan, std::span<const SortedRun> runs, ClassColumns classes,
                  const std::filesystem::path& folder) {
  if (plan.points > UINT32_MAX)
    throw Error("more than 4 billion points coincide at one place; remove duplicates from the input first");
  const auto memory = std::make_unique_for_overwrite<KeyValue[]>(2 * plan.points);
  const std::span<const KeyValue> points = merge(plan, runs, {memory.get(), 2 * plan.points});
  const std::vector<ChunkBox> chunks = chunk_boxes(points);
  const std::string stem = folder / (plan.node.name() + ".");
  write_values(stem, columns::kCodes, points, [](const KeyValue& p) { return p.key; });
  write_values(stem, columns::kOrder, points, [](const KeyValue& p) { return order_of(p.value); });
  if (classes == ClassColumns::written) {
    write_values(stem, columns::kClass, points, [](const KeyValue& p) { return class_of(p.value); });
    write_values(stem, columns::kEchoes, points, [](const KeyValue& p) { return echoes_of(p.value); });
  }
  write_column<ChunkBox>(stem + columns::kChunks.info.name, chunks);
  return {plan.node, static_cast<std::uint32_t>(plan.points), bounds(chunks, plan.node.tile)};
}

}  // namespace ilot
