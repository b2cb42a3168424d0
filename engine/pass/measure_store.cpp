// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/measure_store.h"

#include <algorithm>
#include <span>
#include <vector>

#include "engine/pass/measured_cells.h"
#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesOfPoint = 10;        // code, class and echoes
constexpr std::uint64_t kBytesOfTask = 16u << 20;  // windows and cells
constexpr std::uint64_t kPointsOfTask = 1u << 20;  // least number; a task is some blocks in a row
constexpr std::size_t kTasksAtOnce = 32;           // at most; their windows and cells are kept until all are done

// Blocks in a row.
struct BlockRange {
  std::uint32_t first = 0, end = 0;
  std::uint32_t largest = 0;  // points of a block
};

class StoreMeasure {
 public:
  StoreMeasure(const Store& store, const PassContext& context)
      : store_(store),
        budget_(context.budget_bytes),
        all_(store.box(), store.points(), store.unit() * context.metres_per_unit) {}

  CloudMeasure measure() {
    const MeasuredCells none = all_;
    const std::vector<BlockRange> ranges = ranges_of_blocks();
    const std::size_t at_once = std::clamp<std::size_t>(budget_ / (2 * kBytesOfTask), 1, kTasksAtOnce);
    for (std::size_t first = 0; first < ranges.size(); first += at_once)
      add(std::span(ranges).subspan(first, std::min(at_once, ranges.size() - first)), none);
    return all_.measure();
  }

 private:
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
  void add(std::span<const BlockRange> ranges, const MeasuredCells& none) {
    std::vector<PassTask> tasks;
    for (const BlockRange& range : ranges) tasks.push_back({range.largest * kBytesOfPoint + kBytesOfTask, 0});
    std::vector<MeasuredCells> parts(tasks.size(), none);
    run_pass(tasks, budget_, [&](std::size_t i) {
      for (std::uint32_t block = ranges[i].first; block < ranges[i].end; ++block) measure_block(block, parts[i]);
    });
    for (const MeasuredCells& part : parts) all_.add(part);
  }

  void measure_block(std::uint32_t block, MeasuredCells& part) const {
    for (const std::uint64_t code : store_.read(block, columns::kCodes))
      part.add(index_of({store_.blocks()[block].node.tile, code}));
    if (store_.has(block, columns::kClass))
      for (const std::uint8_t code : store_.read(block, columns::kClass)) part.add_class(code);
    if (store_.has(block, columns::kEchoes))
      for (const std::uint8_t echoes : store_.read(block, columns::kEchoes)) part.add_echoes(echoes);
  }

  const Store& store_;
  std::uint64_t budget_;
  MeasuredCells all_;
};

}  // namespace

CloudMeasure measure_store(const Store& store, const PassContext& context) {
  return store.points() == 0 ? CloudMeasure{} : StoreMeasure(store, context).measure();
}

}  // namespace ilot
