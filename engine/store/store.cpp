// SPDX-License-Identifier: Apache-2.0
#include "engine/store/store.h"

namespace ilot {

Store::Store(std::filesystem::path folder, double unit, std::vector<Block> blocks)
    : folder_(std::move(folder)), unit_(unit), blocks_(std::move(blocks)) {
  for (const Block& b : blocks_) points_ += b.points;
}

std::vector<std::uint32_t> Store::blocks_in(const IndexBox& box) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].box.intersects(box)) found.push_back(i);
  return found;
}

std::filesystem::path Store::file(std::uint32_t block, const char* column) const {
  return folder_ / "blocks" / (blocks_[block].node.name() + "." + column);
}

}  // namespace ilot
