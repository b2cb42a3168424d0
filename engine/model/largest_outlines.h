// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "engine/model/outline.h"

namespace ilot {

// Keeps outlines of planes for later steps within a bound. When there are more than `most_corners` corners, the
// smallest planes are removed until half of the corners remain. The same outlines in the same order give the same
// result. 24 bytes a corner.
class LargestOutlines {
 public:
  explicit LargestOutlines(std::size_t most_corners = 0) : most_corners_(most_corners) {}

  void add(const Outline& outline, double area);
  std::span<const Outline> outlines() const { return outlines_; }
  std::size_t dropped() const { return dropped_; }  // planes

 private:
  void drop_smallest();

  std::size_t most_corners_, corners_ = 0, dropped_ = 0;
  std::vector<Outline> outlines_;
  std::vector<double> areas_;
};

}  // namespace ilot
