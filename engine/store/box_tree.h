// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// Finds boxes of a list that is ordered along a curve through space, as blocks and cells are: neighbours in the list
// are mostly near each other, so a box around each eight of them, around each eight of these and so on leaves out most
// of the list at once. The answer does not depend on the order. Memory: a seventh of the boxes.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const IndexBox> boxes);

  // Adds the indices, ascending, of the boxes that intersect this one (closed). `boxes`: those it was made of.
  // O(answer * log n) for boxes in the order of a space-filling curve.
  void find(std::span<const IndexBox> boxes, const IndexBox& box, std::vector<std::uint32_t>& found) const;

 private:
  std::vector<std::vector<IndexBox>> levels_;  // boxes around eights of the level below, the first around the list's
};

}  // namespace ilot
