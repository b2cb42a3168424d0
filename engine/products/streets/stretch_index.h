// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "engine/products/streets/blocks/city_blocks.h"
#include "engine/tiles/raster_scale.h"

namespace ilot {

// The block beside a place: stretch and block from 1, 0 = none.
struct BlockAddress {
  std::uint32_t stretch = 0, block = 0;
};

// Lines of facades by where they are, so that a place looks at those near to it only.
class StretchIndex {
 public:
  StretchIndex(const std::vector<StreetStretch>& stretches, const RasterScale& scale);

  // Of pixels of the whole: the nearest line of facades within 30 m, of equally near ones the first, and of its blocks
  // the one nearest along it. O(log cells + lines near by).
  BlockAddress address(double x, double y) const;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;  // row, column
  Cell cell_of(double x, double y) const;

  const std::vector<StreetStretch>& stretches_;
  double pixel_;                                     // metres
  std::map<Cell, std::vector<std::uint32_t>> near_;  // of each cell the lines within reach of it, rising
};

}  // namespace ilot
