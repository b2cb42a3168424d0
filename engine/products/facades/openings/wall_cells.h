// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

namespace ilot {

// The wall in square cells from its lower left corner, row by row upwards: what its rays tell of each.
struct WallCells {
  enum What : std::uint8_t {
    kUnknown,
    kSolid,
    kThrough,
    kBlocked,  // something before the wall
    kShallow,  // too little behind it to be an opening: joints of stone
  };

  double cell = 0;  // metres
  std::int64_t columns = 0, rows = 0;
  std::vector<std::uint8_t> what;

  std::uint8_t& at(std::int64_t c, std::int64_t r) { return what[static_cast<std::size_t>(r * columns + c)]; }
  std::uint8_t at(std::int64_t c, std::int64_t r) const { return what[static_cast<std::size_t>(r * columns + c)]; }
};

// What the search for openings went by.
struct OpeningSteps {
  WallCells seen, filled;  // as rays tell, and joined over cells that nothing was seen in
};

}  // namespace ilot
