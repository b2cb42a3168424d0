// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: which parts of a component are joined, and in which order.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/objects/columns.h"
#include "kernels/rasters/image.h"

namespace ilot {

struct Join {
  std::uint32_t a = 0, b = 0;
  double pass = 1;  // height of the pass divided by the height of the lower top
};
struct Joins {
  std::vector<Join> list;
  std::vector<double> outer;  // of each part and join, from 1: highest pass to another divided by the lower top
};

// Builds the tree of joins of the labels of a component. First, columns are joined one after the other with the parts
// from which they were cut, so that the tree contains all nodes that it would contain without the cuts. Then the two
// candidates whose pass is highest relative to the lower top are joined, again and again. Then candidates that are
// separated by a gap of at most `reach` pixels are joined. No join has more than `largest` pixels. Join j (from 0)
// gives the candidate with the number labels.count + 1 + j.
Joins joins_of(const PixelLabels& labels, const Image& heights, std::uint32_t reach, double largest,
               std::span<const ColumnCut> cuts = {});

}  // namespace ilot
