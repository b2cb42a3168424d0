// SPDX-License-Identifier: Apache-2.0
// What buildings say of their points, on its way back to the blocks: buildings come in the order of their ids, blocks
// want their points in theirs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
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

struct LabelledPoint {
  std::uint32_t block = 0, point = 0;
  RoofLabel label;
};

// Labels by batches of buildings, a file a batch in the store's folder "roofs".
class RoofLabels {
 public:
  explicit RoofLabels(const Store& store);

  // The labels of some buildings. Of two labels of a point the smaller unit's counts, within and over batches: they
  // come in the order of units.
  void add(std::vector<LabelledPoint> points);

  // Writes the column "roof" (RoofLabel) of every block: the labels that were added, and `of_others` (block, point)
  // for the rest.
  void write_columns(const PassContext& context,
                     const std::function<std::vector<PointLabel>(std::uint32_t block)>& of_others) const;

 private:
  struct Run {
    std::uint32_t batch = 0;
    std::uint64_t first = 0, count = 0;
  };
  std::filesystem::path path(std::uint32_t batch) const;
  std::vector<RoofLabel> of_block(std::uint32_t block) const;

  const Store& store_;
  std::uint32_t batches_ = 0;
  std::vector<std::vector<Run>> runs_;  // per block, in the order of batches
};

}  // namespace ilot
