// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "engine/store/view.h"

namespace ilot {

constexpr std::uint32_t kStretchPoints = 1 << 14;

// Consecutive points of one block.
struct Stretch {
  std::uint32_t block = 0, first = 0;    // index in the block of the first of them
  Tile tile;                             // gives with a code the place of a point
  std::span<const std::uint64_t> codes;  // valid during the visit

  Index3 position(std::size_t i) const { return index_of({tile, codes[i]}); }

  // Returns another column of the same points.
  template <class T>
  std::vector<T> read(const Store& store, const Column<T>& column) const {
    return store.read(block, column, first, static_cast<std::uint32_t>(codes.size()));
  }
};

// Calls visit(stretch) for the points of the slices in their order, at most kStretchPoints at a time, in 128 KiB of
// memory for any number of points. A view of a box also contains points outside it.
template <class Visit>
void for_each_stretch(const Store& store, std::span<const Slice> slices, const Visit& visit) {
  std::vector<std::uint64_t> codes;
  for (const Slice& s : slices) {
    const auto reader = store.open(s.block, columns::kCodes);
    const Tile tile = store.blocks()[s.block].node.tile;
    for (std::uint32_t done = 0; done < s.count; done += kStretchPoints) {
      codes.resize(std::min(kStretchPoints, s.count - done));
      reader.read(s.first + done, codes);
      visit(Stretch{s.block, s.first + done, tile, codes});
    }
  }
}

}  // namespace ilot
