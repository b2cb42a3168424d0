// SPDX-License-Identifier: Apache-2.0
// Inside of find_object_candidates: which parts of a component are joined, and in which order.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/objects/columns.h"
#include "kernels/rasters/image.h"

namespace ilot {

struct Join {
  std::uint32_t a = 0, b = 0;
  double pass = 1;  // over the lower top
};
struct Joins {
  std::vector<Join> list;
  std::vector<double> outer;  // of each part and each join, from 1: the highest pass to another over the lower top
};

// The tree of joins of the labels of a component: columns with what they were cut from first, one after the other, so
// that the tree holds all that it would hold without them; then the two whose pass is highest beside the lower top,
// again and again, then those that a gap of at most `reach` pixels parts, to no more than `largest` pixels. What join j
// (from 0) makes has the number labels.count + 1 + j.
Joins joins_of(const PixelLabels& labels, const Image& heights, std::uint32_t reach, double largest,
               std::span<const ColumnCut> cuts = {});

}  // namespace ilot
