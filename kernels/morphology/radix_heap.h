// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Priority queue of pixels by height, the lowest first, for floods that only rise: a pushed height is never below the
// last one popped. The order of equal heights is unspecified. It is a radix heap (Ahuja, Mehlhorn, Orlin, Tarjan 1990):
// a push is O(1), and each pixel is moved at most 32 times in all.
class RadixHeap {
 public:
  struct Item {
    std::uint32_t key, pixel;
    Height height() const { return static_cast<Height>(key ^ kSign); }
  };

  bool empty() const { return size_ == 0; }

  void push(Height height, std::uint32_t pixel) {
    const std::uint32_t key = static_cast<std::uint32_t>(height) ^ kSign;
    assert(key >= last_);
    buckets_[static_cast<std::size_t>(std::bit_width(key ^ last_))].push_back({key, pixel});
    ++size_;
  }

  // Precondition of pop() and pop_level(): the heap is not empty.
  Item pop() {
    if (buckets_[0].empty()) refill();
    const Item item = buckets_[0].back();
    buckets_[0].pop_back();
    --size_;
    return item;
  }

  // Removes all pixels of the least height at once. Their order is unspecified.
  Height pop_level(std::vector<std::uint32_t>& pixels) {
    if (buckets_[0].empty()) refill();
    pixels.clear();
    for (const Item& item : buckets_[0]) pixels.push_back(item.pixel);
    size_ -= pixels.size();
    buckets_[0].clear();
    return static_cast<Height>(last_ ^ kSign);
  }

 private:
  static constexpr std::uint32_t kSign = 0x80000000u;

  // Spreads the lowest bucket that is not empty over the buckets below it.
  void refill() {
    std::size_t b = 1;
    while (buckets_[b].empty()) ++b;
    last_ = buckets_[b].front().key;
    for (const Item& item : buckets_[b])
      if (item.key < last_) last_ = item.key;
    for (const Item& item : buckets_[b])
      buckets_[static_cast<std::size_t>(std::bit_width(item.key ^ last_))].push_back(item);
    buckets_[b].clear();
  }

  std::vector<Item> buckets_[33];
  std::uint32_t last_ = 0;
  std::size_t size_ = 0;
};

}  // namespace ilot
