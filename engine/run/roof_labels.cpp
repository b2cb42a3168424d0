// SPDX-License-Identifier: Apache-2.0
#include "engine/run/roof_labels.h"

#include <algorithm>
#include <tuple>

#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 40;

// What a file holds of a point: the block is known by the place in the file.
struct StoredLabel {
  std::uint32_t point = 0;
  RoofLabel label;
};

}  // namespace

RoofLabels::RoofLabels(const Store& store) : store_(store), runs_(store.blocks().size()) {
  std::filesystem::remove_all(store.folder() / "roofs");
  std::filesystem::create_directories(store.folder() / "roofs");
}

std::filesystem::path RoofLabels::path(std::uint32_t batch) const {
  return store_.folder() / "roofs" / ("labels-" + std::to_string(batch));
}

void RoofLabels::add(std::vector<LabelledPoint> points) {
  if (points.empty()) return;
  std::sort(points.begin(), points.end(), [](const LabelledPoint& a, const LabelledPoint& b) {
    return std::tie(a.block, a.point, a.label.unit) < std::tie(b.block, b.point, b.label.unit);
  });
  std::vector<StoredLabel> stored;
  stored.reserve(points.size());
  for (const LabelledPoint& p : points) {
    auto& runs = runs_[p.block];
    if (runs.empty() || runs.back().batch != batches_) runs.push_back({batches_, stored.size(), 0});
    ++runs.back().count;
    stored.push_back({p.point, p.label});
  }
  write_column<StoredLabel>(path(batches_), stored);
  ++batches_;
}

std::vector<RoofLabel> RoofLabels::of_block(std::uint32_t block) const {
  std::vector<RoofLabel> labels(store_.blocks()[block].points);
  std::vector<StoredLabel> stored;
  for (const Run& run : runs_[block]) {
    stored.resize(run.count);
    ColumnReader<StoredLabel>(path(run.batch)).read(run.first, stored);
    for (const StoredLabel& s : stored)
      if (labels[s.point].unit == 0) labels[s.point] = s.label;
  }
  return labels;
}

void RoofLabels::write_columns(const PassContext& context,
                               const std::function<std::vector<PointLabel>(std::uint32_t)>& of_others) const {
  std::vector<PassTask> tasks;
  for (const Block& b : store_.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    std::vector<RoofLabel> labels = of_block(block);
    const std::vector<PointLabel> others = of_others(block);
    for (std::size_t p = 0; p < labels.size(); ++p)
      if (labels[p].unit == 0) labels[p].label = others[p];
    store_.write(block, columns::kRoof, labels);
  });
}

}  // namespace ilot
