// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

namespace ilot {

// The wall in square cells, from its lower left corner, row by row upwards. Each cell has what its rays show.
struct WallCells {
  enum What : std::uint8_t {
    kUnknown,
    kSolid,
    kThrough,
    kBlocked,  // something stands before the wall
    kShallow,  // too shallow to be an opening: joints of stone
  };

  double cell = 0;  // metres
  std::int64_t columns = 0, rows = 0;
  std::vector<std::uint8_t> what;

  std::uint8_t& at(std::int64_t c, std::int64_t r) { return what[static_cast<std::size_t>(r * columns + c)]; }
  std::uint8_t at(std::int64_t c, std::int64_t r) const { return what[static_cast<std::size_t>(r * columns + c)]; }
};

// The intermediate images of the search for openings.
struct OpeningSteps {
  WallCells seen, filled;  // as the rays show them; joined over cells in which nothing was seen
};

}  // namespace ilot
