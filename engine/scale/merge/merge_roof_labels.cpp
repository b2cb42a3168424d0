// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge/merge_roof_labels.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <string>

#include "engine/columns/point_roles.h"
#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/products/roofs/roof_roles.h"
#include "engine/scale/parts/roof_label_records.h"
#include "engine/scale/records.h"
#include "engine/store/column_file.h"
#include "engine/store/stretches.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// Derived: a record of kStretchPoints labels of 20 bytes, three times while it is read.
constexpr std::uint64_t kBytesOfRecord = std::uint64_t{kStretchPoints} * 20 * 3;
constexpr std::uint64_t kBytesOfPoint = 16;  // of a block: its code, and the label of some of its points

// Labels of one building for one block, at their place in the files.
struct Piece {
  BuildingNumbers building;
  std::uint32_t count = 0;
  std::uint64_t first = 0;
};

// The labels of all buildings by block: their codes and themselves in two files of the store's folder.
class LabelsByBlock {
 public:
  explicit LabelsByBlock(const Store& store)
      : store_(store),
        codes_(store.folder() / "label_codes"),
        labels_(store.folder() / "label_values"),
        pieces_(store.blocks().size()) {}

  // From any thread. Labels of points that the store does not have, because a part is missing, are left out.
  void add(const BuildingNumbers& building, const PlacedLabels& placed) {
    const auto& blocks = store_.blocks();
    const std::lock_guard lock(writing_);
    for (std::size_t i = 0; i < placed.codes.size();) {
      const auto behind =
          std::ranges::upper_bound(blocks, PointKey{placed.tile, placed.codes[i]}, {}, [](const Block& b) {
            return PointKey{b.node.tile, b.node.first_code};
          });
      const auto block = static_cast<std::size_t>(behind - blocks.begin());
      const auto in_block = [&](std::uint64_t code) {
        const Node& node = blocks[block - 1].node;
        return node.tile == placed.tile && node.first_code <= code && code <= node.last_code();
      };
      std::size_t end = i + 1;
      if (block > 0 && in_block(placed.codes[i])) {
        while (end < placed.codes.size() && in_block(placed.codes[end])) ++end;
        keep(building, placed, i, end, pieces_[block - 1]);
      }
      i = end;
    }
  }

  void commit() {
    codes_.commit();
    labels_.commit();
  }

  // Hands the labels of a block to those of the whole store, in the order of buildings.
  void give(std::uint32_t block, RoofLabels& all) {
    std::vector<Piece>& pieces = pieces_[block];
    if (pieces.empty()) return;
    std::ranges::sort(pieces, {}, [](const Piece& p) { return std::pair{p.building.unit, p.first}; });
    const auto codes = store_.read(block, columns::kCodes);
    const ColumnReader<std::uint64_t> stored_codes(store_.folder() / "label_codes");
    const ColumnReader<SitePointLabel> stored_labels(store_.folder() / "label_values");
    for (const Piece& piece : pieces) {
      std::vector<std::uint64_t> at(piece.count);
      std::vector<SitePointLabel> labels(piece.count);
      stored_codes.read(piece.first, at);
      stored_labels.read(piece.first, labels);
      find_points(codes, at, labels);
      const LabelRun run = all.store_labels(block, labels);
      all.add(piece.building.unit, piece.building.first_plane, std::span(&run, 1));
    }
  }

 private:
  void keep(const BuildingNumbers& building, const PlacedLabels& placed, std::size_t first, std::size_t end,
            std::vector<Piece>& pieces) {
    codes_.append(std::span(placed.codes).subspan(first, end - first));
    labels_.append(std::span(placed.labels).subspan(first, end - first));
    pieces.push_back({building, static_cast<std::uint32_t>(end - first), written_});
    written_ += end - first;
  }

  const Store& store_;
  std::mutex writing_;
  ColumnWriter<std::uint64_t> codes_;
  ColumnWriter<SitePointLabel> labels_;
  std::uint64_t written_ = 0;
  std::vector<std::vector<Piece>> pieces_;
};

void read_labels(const fs::path& file, const std::vector<BuildingNumbers>& numbers, LabelsByBlock& labels) {
  RecordFileReader reader(file);
  try {
    while (const auto record = reader.next()) {
      stop_if_asked();
      const PlacedLabels placed = placed_labels(*record);
      if (placed.site >= numbers.size()) throw Error("a part has labels of a building that it does not have");
      labels.add(numbers[placed.site], placed);
    }
  } catch (const nlohmann::json::exception&) {
    throw Error("part " + file.filename().string() + " is damaged; remove it and run its task again");
  }
}

std::vector<PointLabel> labels_of_ground(const Store& store, std::uint32_t block) {
  std::vector<PointLabel> labels;
  for (const PointRole role : store.read(block, columns::kRole))
    labels.push_back(role == PointRole::ground ? PointLabel::ground : PointLabel::none);
  return labels;
}

RoleCounts count_roles(const Store& store, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * sizeof(PointRole), b.points});
  std::vector<RoleCounts> counts(tasks.size());
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    for (const PointRole role : store.read(static_cast<std::uint32_t>(i), columns::kRole))
      ++counts[i].at(static_cast<std::size_t>(role));
  });
  return sum_of(counts);
}

}  // namespace

std::vector<ChosenRecord> chosen_of_roofs(const Plan& plan, const Store& store, const PassContext& context) {
  std::vector<ChosenRecord> chosen = plan.chosen;
  if (!plan.roofs.by_shape) return chosen;
  const std::string why = found_by_shape(count_roles(store, context));
  for (ChosenRecord& record : chosen)
    if (record.key == "roofs.trust_classes") record.why = why;
  return chosen;
}

void merge_roof_labels(const Store& store, const fs::path& labels, const std::vector<std::uint64_t>& areas,
                       const MergedRoofs& roofs, const PassContext& context) {
  LabelsByBlock by_block(store);
  run_pass(std::vector<PassTask>(areas.size(), {kBytesOfRecord, 1}), context.budget_bytes,
           [&](std::size_t i) { read_labels(labels / std::to_string(areas[i]), roofs.numbers[i], by_block); });
  by_block.commit();
  RoofLabels all(store);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesOfPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) { by_block.give(static_cast<std::uint32_t>(i), all); });
  all.write_columns(context, [&](std::uint32_t block) { return labels_of_ground(store, block); });
}

}  // namespace ilot
