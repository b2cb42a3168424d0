// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/classifiers/boosted_trees.h"

namespace ilot {

struct TreeBoostingParams {
  std::size_t rounds = 60;     // trees of each class
  std::size_t depth = 4;       // at most 7
  std::size_t bins = 64;       // of a column, at most 256: evenly many values each
  double shrinkage = 0.15;     // of what a tree adds
  double ridge = 1;            // added to the curvature of a leaf
  double least_curvature = 1;  // of a leaf: sum of p (1 - p) over its rows
};

// Rows of values, a row after the other, and the class of each.
struct TreeSamples {
  std::size_t columns = 0, classes = 0;
  std::span<const double> values;           // columns of each row; finite
  std::span<const std::uint32_t> of_class;  // below classes
};

// Learns trees that tell classes apart: gradient boosting of the multinomial likelihood by Newton steps (Friedman 2001;
// Chen and Guestrin 2016) on histograms of binned values. In each round a tree for each class, from the shares before
// the round; each tree level by level, each node parted where the gain is greatest (ties: the lower column, then the
// lower limit), or not at all where there is none. Gradients are whole multiples of 2^-20 and are summed as such, so
// the order of the rows and the number of threads do not show. Limits that no tree asks for are left out. No random
// draw. A class without rows is told never. O(rounds classes depth rows columns) at most: of two nodes only the lesser
// is counted; memory some columns + 20 classes bytes a row.
BoostedTrees boost_trees(const TreeSamples& samples, const TreeBoostingParams& params = {});

}  // namespace ilot
