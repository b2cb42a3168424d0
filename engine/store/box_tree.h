// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// Finds boxes in a list that is ordered along a space-filling curve, like blocks and cells. Neighbours in the list are
// mostly near each other. So the tree has a box around each eight boxes, a box around each eight of these and so on,
// and one test excludes a large part of the list. The result does not depend on the order. Memory: a seventh of the
// boxes.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const IndexBox> boxes);

  // Adds the indices, ascending, of the boxes that intersect this box (closed). `boxes` are those from which the tree
  // was made. O(answer * log n) for boxes in the order of a space-filling curve.
  void find(std::span<const IndexBox> boxes, const IndexBox& box, std::vector<std::uint32_t>& found) const;

 private:
  std::vector<std::vector<IndexBox>> levels_;  // each level has boxes around groups of eight of the level below; the
                                               // first has those around groups of the list
};

}  // namespace ilot
