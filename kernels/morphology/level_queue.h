// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cassert>
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Priority queue of pixels by height, the lowest first, for floods that only rise and contain each pixel once. It has a
// list of pixels for every height. The order of equal heights is unspecified. A push is O(1) and all pops together are
// O(range). It needs 4 bytes per pixel and 4 bytes per height of the range.
class LevelQueue {
 public:
  // Heights go from `low` to low + levels - 1.
  LevelQueue(Height low, std::uint32_t levels, std::size_t pixels) : low_(low), first_(levels, kEnd), next_(pixels) {}

  bool empty() const { return size_ == 0; }

  // The height must not be below the last one popped. The pixel must not be in the queue.
  void push(Height height, std::uint32_t pixel) {
    const std::uint32_t level = static_cast<std::uint32_t>(height) - static_cast<std::uint32_t>(low_);
    assert(level >= level_ && level < first_.size());
    next_[pixel] = first_[level];
    first_[level] = pixel;
    ++size_;
  }

  struct Item {
    Height at;
    std::uint32_t pixel;
    Height height() const { return at; }
  };
  // Precondition: not empty.
  Item pop() {
    while (first_[level_] == kEnd) ++level_;
    const std::uint32_t pixel = first_[level_];
    first_[level_] = next_[pixel];
    --size_;
    return {static_cast<Height>(static_cast<std::uint32_t>(low_) + level_), pixel};
  }

 private:
  static constexpr std::uint32_t kEnd = 0xffffffffu;
  Height low_;
  std::uint32_t level_ = 0;
  std::vector<std::uint32_t> first_;  // of each level
  std::vector<std::uint32_t> next_;   // of each pixel in the queue
  std::size_t size_ = 0;
};

}  // namespace ilot
