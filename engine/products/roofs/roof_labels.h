// SPDX-License-Identifier: Apache-2.0
// What buildings say of their points, on its way back to the blocks: buildings come in the order of their ids, blocks
// want their points in theirs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/model/point_label.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

struct RoofLabel {
  std::uint32_t unit = 0, plane = 0;  // 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused[3] = {};  // written to disk
};

// What a building says of a point of a block before the numbers of the units and planes before it are known.
struct SitePointLabel {
  std::uint32_t point = 0;
  std::uint32_t plane = 0;  // of the building, from 1; 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused[3] = {};  // written to disk
};

// Labels that were put aside: where they are in the file.
struct LabelRun {
  std::uint32_t block = 0, count = 0;
  std::uint64_t first = 0;
};

// Labels of all buildings, in one file of the store's folder "roofs". In memory 24 bytes a run of them.
class RoofLabels {
 public:
  explicit RoofLabels(const Store& store);

  // Puts labels of a building for points of one block aside. From any thread.
  LabelRun store_labels(std::uint32_t block, std::span<const SitePointLabel> labels);

  // A building's runs, units in ascending order; its plane 1 is first_plane. Of two labels of a point the smaller
  // unit's counts.
  void add(std::uint32_t unit, std::uint32_t first_plane, std::span<const LabelRun> runs);

  // Writes the column "roof" (RoofLabel) of every block: the labels that were added, and `of_others` (block, point)
  // for the rest. Once, when all were added.
  void write_columns(const PassContext& context,
                     const std::function<std::vector<PointLabel>(std::uint32_t block)>& of_others);

 private:
  struct Run {
    std::uint64_t first = 0;
    std::uint32_t count = 0, unit = 0, first_plane = 0;
  };
  std::vector<RoofLabel> of_block(std::uint32_t block) const;

  const Store& store_;
  std::filesystem::path path_;
  std::mutex writing_;
  std::unique_ptr<ColumnWriter<SitePointLabel>> file_;
  std::uint64_t written_ = 0;
  std::vector<std::vector<Run>> runs_;  // per block, in the order of units
};

}  // namespace ilot
