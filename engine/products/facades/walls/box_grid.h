// SPDX-License-Identifier: Apache-2.0
// Finds boxes on the ground that are near a box, by cells: the time for a city grows with the number of its houses.
#pragma once
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

// The memory grows with the number of cells that the boxes cover. A box that covers more than 1,024 cells counts as
// near to everything.
class BoxGrid {
 public:
  explicit BoxGrid(double cell) : cell_(cell) {}

  // One number may have more than one box.
  void add(std::uint32_t number, const FlatBox& box);

  // The numbers of all boxes that meet this one, and of some others: ascending, each number once.
  std::vector<std::uint32_t> near(const FlatBox& box) const;

 private:
  struct Cells {
    std::int64_t c0 = 0, c1 = 0, r0 = 0, r1 = 0;
  };
  // Derived: a bound of memory and time for one box.
  static constexpr double kMostCells = 1024;
  // Derived: below 2^53, so that numbers of cells are exact.
  static constexpr double kFarthest = 1e15;               // cells
  bool cells_of(const FlatBox& box, Cells& cells) const;  // false: too many cells

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> numbers_;  // by cell
  std::vector<std::uint32_t> everywhere_, all_;
};

}  // namespace ilot
