// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/measure_store.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "engine/pass/pass.h"
#include "engine/pass/sampled_windows.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesOfPoint = 10;        // code, class and echoes
constexpr std::uint64_t kBytesOfTask = 8u << 20;   // windows and cells
constexpr std::uint64_t kPointsOfTask = 1u << 20;  // least number; a task is some blocks in a row
constexpr std::size_t kTasksAtOnce = 32;           // at most; their windows and cells are kept until all are done

// Blocks in a row.
struct BlockRange {
  std::uint32_t first = 0, end = 0;
  std::uint32_t largest = 0;  // points of a block
};

// What some blocks in a row have.
struct MeasuredPart {
  SampledWindows windows;
  std::vector<bool> occupied;
  std::array<std::uint64_t, 256> classes{};
  std::uint64_t not_last = 0;
};

class StoreMeasure {
 public:
  StoreMeasure(const Store& store, const PassContext& context)
      : store_(store), metres_(store.unit() * context.metres_per_unit), budget_(context.budget_bytes) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    m_.min = {kFar, kFar, kFar}, m_.max = {-kFar, -kFar, -kFar};
    for (const Block& b : store.blocks()) {
      const Vec3 low = at(b.box.min), high = at(b.box.max);
      m_.min = {std::min(m_.min.x, low.x), std::min(m_.min.y, low.y), std::min(m_.min.z, low.z)};
      m_.max = {std::max(m_.max.x, high.x), std::max(m_.max.y, high.y), std::max(m_.max.z, high.z)};
    }
  }

  CloudMeasure measure() {
    m_.points = store_.points();
    if (m_.points == 0) return {};
    m_.all_min = m_.min, m_.all_max = m_.max;
    const auto total = static_cast<double>(m_.points);
    const MeasureGrid cells = density_cells(m_.min, m_.max, total), windows = step_windows(m_.min, m_.max, total);
    MeasuredPart all;
    all.occupied.resize(cells.columns * cells.rows);
    const std::vector<BlockRange> ranges = ranges_of_blocks();
    const std::size_t at_once = std::clamp<std::size_t>(budget_ / (2 * kBytesOfTask), 1, kTasksAtOnce);
    for (std::size_t first = 0; first < ranges.size(); first += at_once)
      add(std::span(ranges).subspan(first, std::min(at_once, ranges.size() - first)), cells, windows, all);
    m_.classes = all.classes;
    m_.last_returns = m_.points - all.not_last;
    const auto full = static_cast<double>(std::count(all.occupied.begin(), all.occupied.end(), true));
    m_.occupied_area = full * cells.side * cells.side;
    m_.density = total / m_.occupied_area;
    m_.last_return_density = static_cast<double>(m_.last_returns) / m_.occupied_area;
    m_.sampling_step = all.windows.median_step();
    return m_;
  }

 private:
  Vec3 at(Index3 p) const {
    return {static_cast<double>(p.x) * metres_, static_cast<double>(p.y) * metres_, static_cast<double>(p.z) * metres_};
  }

  std::vector<BlockRange> ranges_of_blocks() const {
    std::vector<BlockRange> ranges;
    std::uint64_t points = kPointsOfTask;
    for (const Block& block : store_.blocks()) {
      if (points >= kPointsOfTask) {
        const std::uint32_t first = ranges.empty() ? 0 : ranges.back().end;
        ranges.push_back({first, first, 0});
        points = 0;
      }
      points += block.points;
      ++ranges.back().end;
      ranges.back().largest = std::max(ranges.back().largest, block.points);
    }
    return ranges;
  }

  // Adds these blocks in their order.
  void add(std::span<const BlockRange> ranges, const MeasureGrid& cells, const MeasureGrid& windows,
           MeasuredPart& all) const {
    std::vector<PassTask> tasks;
    for (const BlockRange& range : ranges) tasks.push_back({range.largest * kBytesOfPoint + kBytesOfTask, 0});
    std::vector<MeasuredPart> parts(tasks.size());
    run_pass(tasks, budget_, [&](std::size_t i) {
      parts[i].occupied.resize(cells.columns * cells.rows);
      for (std::uint32_t block = ranges[i].first; block < ranges[i].end; ++block)
        measure_block(block, cells, windows, parts[i]);
    });
    for (const MeasuredPart& part : parts) {
      all.windows.add(part.windows);
      all.not_last += part.not_last;
      for (std::size_t c = 0; c < all.occupied.size(); ++c)
        if (part.occupied[c]) all.occupied[c] = true;
      for (std::size_t c = 0; c < all.classes.size(); ++c) all.classes[c] += part.classes[c];
    }
  }

  void measure_block(std::uint32_t block, const MeasureGrid& cells, const MeasureGrid& windows,
                     MeasuredPart& part) const {
    for (const std::uint64_t code : store_.read(block, columns::kCodes)) {
      const Vec3 p = at(index_of({store_.blocks()[block].node.tile, code}));
      part.occupied[cells.cell(p)] = true;
      part.windows.add(windows.cell(p), p - m_.min);
    }
    if (store_.has(block, columns::kClass))
      for (const std::uint8_t code : store_.read(block, columns::kClass)) ++part.classes[code];
    if (store_.has(block, columns::kEchoes))
      for (const std::uint8_t echo : store_.read(block, columns::kEchoes))
        part.not_last += (echo & kNotLastReturn) != 0;
  }

  const Store& store_;
  double metres_;  // of a step of the lattice
  std::uint64_t budget_;
  CloudMeasure m_;
};

}  // namespace

CloudMeasure measure_store(const Store& store, const PassContext& context) {
  return StoreMeasure(store, context).measure();
}

}  // namespace ilot
