// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/edits/class_edits.h"

#include <cmath>
#include <map>
#include <tuple>

#include "engine/pass/pass.h"
#include "engine/products/product_edits.h"

namespace ilot {
namespace {

std::vector<const Edit*> of_classes(std::span<const Edit> edits) {
  std::vector<const Edit*> own = edits_of(edits, "roofs");
  std::erase_if(own, [](const Edit* edit) { return edit->action != EditAction::kind; });
  return own;
}

}  // namespace

ClassEdits::ClassEdits(std::span<const Edit> edits, double unit) : edits_(of_classes(edits)), unit_(unit) {}

PointRole ClassEdits::role(std::size_t i) const {
  const std::string& kind = edits_[i]->to_kind;
  if (kind == "building") return PointRole::building;
  return kind == "ground" ? PointRole::ground : PointRole::other;
}

std::vector<std::size_t> ClassEdits::near(const IndexBox& box) const {
  std::vector<std::size_t> near;
  const auto at = [&](std::int64_t v) { return static_cast<double>(v) * unit_; };
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    const Area& area = edits_[i]->area;
    if (area.min_x <= at(box.max.x) && area.max_x >= at(box.min.x) && area.min_y <= at(box.max.y) &&
        area.max_y >= at(box.min.y))
      near.push_back(i);
  }
  return near;
}

bool ClassEdits::contains(std::size_t i, Index3 point) const {
  const Edit& edit = *edits_[i];
  // Half a step more: a height of the table and that of the lattice differ by rounding.
  const double z = static_cast<double>(point.z) * unit_, half = unit_ / 2;
  if ((edit.low && z < *edit.low - half) || (edit.high && z > *edit.high + half)) return false;
  return edit.area.contains(static_cast<double>(point.x) * unit_, static_cast<double>(point.y) * unit_);
}

void check_class_edits(std::span<const Edit> edits) {
  using Place = std::tuple<std::vector<AreaRing>, double, double>;
  std::map<Place, const Edit*> by_place;
  for (const Edit* edit : of_classes(edits)) {
    Place place{edit->area.rings, edit->low.value_or(-HUGE_VAL), edit->high.value_or(HUGE_VAL)};
    const auto [earlier, first] = by_place.try_emplace(std::move(place), edit);
    if (!first && earlier->second->to_kind != edit->to_kind) refuse_contradiction(*earlier->second, *edit);
  }
}

std::vector<std::uint64_t> edit_roles(const Store& store, const ClassEdits& edits, const PassContext& context) {
  struct BlockOfEdits {
    std::uint32_t block;
    std::vector<std::size_t> near;
  };
  std::vector<BlockOfEdits> blocks;
  std::vector<PassTask> tasks;
  constexpr std::uint64_t kBytesOfPoint = sizeof(std::uint64_t) + 2 * sizeof(PointRole);
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    std::vector<std::size_t> near = edits.near(store.blocks()[b].box);
    if (near.empty()) continue;
    const std::uint64_t points = store.blocks()[b].points;
    tasks.push_back({points * kBytesOfPoint, points});
    blocks.push_back({b, std::move(near)});
  }
  std::vector<std::vector<std::uint64_t>> counts(blocks.size());  // by the place of the edit in `near`
  run_pass(tasks, context.budget_bytes, [&](std::size_t task) {
    const auto& [block, near] = blocks[task];
    counts[task].assign(near.size(), 0);
    const Tile tile = store.blocks()[block].node.tile;
    const std::vector<std::uint64_t> codes = store.read(block, columns::kCodes);
    std::vector<PointRole> roles = store.read(block, columns::kRole);
    for (std::size_t i = 0; i < codes.size(); ++i)
      for (std::size_t n = 0; n < near.size(); ++n) {
        if (!edits.contains(near[n], index_of({tile, codes[i]}))) continue;
        roles[i] = edits.role(near[n]);
        ++counts[task][n];
      }
    store.write(block, columns::kRole, roles);
  });
  std::vector<std::uint64_t> points(edits.size(), 0);
  for (std::size_t task = 0; task < blocks.size(); ++task)
    for (std::size_t n = 0; n < counts[task].size(); ++n) points[blocks[task].near[n]] += counts[task][n];
  return points;
}

}  // namespace ilot
