// SPDX-License-Identifier: Apache-2.0
// Transfers the labels of points from buildings to blocks. Buildings come in the order of their ids, while each block
// needs the labels in the order of its points.
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
#include "engine/products/product_labels.h"
#include "engine/store/store.h"

namespace ilot {

struct RoofLabel {
  std::uint32_t unit = 0, plane = 0;  // 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused[3] = {};  // written to disk
};

// The label that a building gives to a point of a block, before the numbers of the earlier units and planes are known.
struct SitePointLabel {
  std::uint32_t point = 0;
  std::uint32_t plane = 0;  // of the building, from 1; 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t away = 0;        // 0 = in the building's outline, else rising with the distance from it
  std::uint8_t unused[2] = {};  // written to disk
};

// A run of stored labels: its position in the file.
struct LabelRun {
  std::uint32_t block = 0, count = 0;
  std::uint64_t first = 0;
};

// The labels of all buildings, in one file of the store's folder "roofs". Memory: 24 bytes per run of labels.
class RoofLabels {
 public:
  explicit RoofLabels(const Store& store);

  // Stores the labels of a building for points of one block. May be called from any thread.
  LabelRun store_labels(std::uint32_t block, std::span<const SitePointLabel> labels);

  // Adds the runs of a building. Units come in ascending order. Plane 1 of the building gets the number first_plane. If
  // a point has two labels, that of the unit from whose outline it is less far away counts, then that of the smaller
  // unit.
  void add(std::uint32_t unit, std::uint32_t first_plane, std::span<const LabelRun> runs);

  // Writes the column "roof" (RoofLabel) of every block: the labels that were added, and for the other points the
  // labels that `of_others` gives for the block. Call it once, when all labels are added.
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

// Labels from the column "roof". The plane of a point is its roof face: it is the field plane_id where the product
// planes did not run.
ProductLabels roof_labels(bool with_planes);

}  // namespace ilot
