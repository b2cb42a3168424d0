// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "engine/products/streets/blocks/city_blocks.h"
#include "engine/tiles/raster_scale.h"

namespace ilot {

// The block beside a place. Stretch and block are numbered from 1; 0 = none.
struct BlockAddress {
  std::uint32_t stretch = 0, block = 0;
};

// An index of the lines of facades by position, so that a query examines only the lines near it.
class StretchIndex {
 public:
  // Metres from a line of facades beyond which objects belong to no block: `farthest`.
  StretchIndex(const std::vector<StreetStretch>& stretches, const RasterScale& scale, double farthest);

  // The address of a place in pixels of the whole image: the nearest line of facades within reach (ties: the first),
  // and the nearest of its blocks along that line. O(log cells + lines near by).
  BlockAddress address(double x, double y) const;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;  // row, column
  Cell cell_of(double x, double y) const;

  const std::vector<StreetStretch>& stretches_;
  double pixel_, farthest_;                          // metres
  std::map<Cell, std::vector<std::uint32_t>> near_;  // for each cell the lines within reach of it, ascending
};

}  // namespace ilot
