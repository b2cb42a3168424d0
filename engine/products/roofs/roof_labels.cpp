// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/roof_labels.h"

#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 40;

}  // namespace

RoofLabels::RoofLabels(const Store& store)
    : store_(store), path_(store.folder() / "roofs" / "labels"), runs_(store.blocks().size()) {
  std::filesystem::remove_all(path_.parent_path());
  std::filesystem::create_directories(path_.parent_path());
  file_ = std::make_unique<ColumnWriter<SitePointLabel>>(path_);
}

LabelRun RoofLabels::store_labels(std::uint32_t block, std::span<const SitePointLabel> labels) {
  const std::lock_guard lock(writing_);
  file_->append(labels);
  const LabelRun run{block, static_cast<std::uint32_t>(labels.size()), written_};
  written_ += labels.size();
  return run;
}

void RoofLabels::add(std::uint32_t unit, std::uint32_t first_plane, std::span<const LabelRun> runs) {
  for (const LabelRun& run : runs) runs_[run.block].push_back({run.first, run.count, unit, first_plane});
}

std::vector<RoofLabel> RoofLabels::of_block(std::uint32_t block) const {
  std::vector<RoofLabel> labels(store_.blocks()[block].points);
  if (runs_[block].empty()) return labels;
  std::vector<std::uint8_t> away(labels.size());
  const ColumnReader<SitePointLabel> file(path_);
  std::vector<SitePointLabel> part;
  for (const Run& run : runs_[block]) {
    part.resize(run.count);
    file.read(run.first, part);
    for (const SitePointLabel& s : part) {
      RoofLabel& label = labels[s.point];
      if (label.unit != 0 && away[s.point] <= s.away) continue;
      label = {run.unit, s.plane == 0 ? 0 : run.first_plane + s.plane - 1, s.label};
      away[s.point] = s.away;
    }
  }
  return labels;
}

void RoofLabels::write_columns(const PassContext& context,
                               const std::function<std::vector<PointLabel>(std::uint32_t)>& of_others) {
  file_->commit();
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

ProductLabels roof_labels(bool with_planes) {
  const auto face = [](const RoofLabel& l) { return l.plane; };
  ProductLabels labels = product_labels<RoofLabel>(
      [](const Store& store, std::uint32_t block) { return store.read(block, columns::kRoof); }, columns::kRoofRows,
      [](const RoofLabel& l) {
        return PointClass{l.label, l.unit != 0, l.unit != 0};
      },
      {label_field<RoofLabel>(FieldPlace::unit, "unit_id", "building, 0 = none",
                              [](const RoofLabel& l) { return l.unit; }),
       with_planes ? label_field<RoofLabel>(FieldPlace::face, "roof_plane_id", "roof face, 0 = none", face)
                   : label_field<RoofLabel>(FieldPlace::plane, "plane_id", "0 = none", face)});
  labels.gives_classes = true;
  return labels;
}

}  // namespace ilot
