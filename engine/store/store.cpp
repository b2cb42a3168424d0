// SPDX-License-Identifier: Apache-2.0
#include "engine/store/store.h"

namespace ilot {

Store::Store(std::filesystem::path folder, double unit, std::vector<Block> blocks)
    : folder_(std::move(folder)), unit_(unit), blocks_(std::move(blocks)) {
  boxes_.reserve(blocks_.size());
  for (const Block& b : blocks_) {
    points_ += b.points;
    boxes_.push_back(b.box);
  }
  tree_ = BoxTree(boxes_);
}

std::vector<std::uint32_t> Store::blocks_in(const IndexBox& box) const {
  std::vector<std::uint32_t> found;
  tree_.find(boxes_, box, found);
  return found;
}

std::filesystem::path Store::file(std::uint32_t block, const char* column) const {
  return folder_ / "blocks" / (blocks_[block].node.name() + "." + column);
}

IndexBox Store::box() const {
  IndexBox all = IndexBox::none();
  for (const IndexBox& box : boxes_) all.add_box(box);
  return all;
}

}  // namespace ilot
